// Throughput of the concept learner and of ViCT, and of training steps beside plain matrix products
// of the same sizes.

#include <benchmark/benchmark.h>
#include <torch/torch.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <random>

#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/torch/causal_transition.hpp"
#include "conceptplan/learner/torch/concept_trainer.hpp"
#include "conceptplan/learner/torch/frame_synthesizer.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/torch/vict_trainer.hpp"
#include "conceptplan/learner/visual_transition.hpp"
#include "learner/random_crops.hpp"
#include "learner/square_frame.hpp"

namespace conceptplan {
namespace {

ConceptLearner learner() {
  return {tensorsOf(*ConceptNetwork(), "concepts."), EncoderKind::kObjectCentred, "benchmark"};
}

std::vector<EncoderInput> inputs(std::size_t count) {
  std::vector<EncoderInput> inputs;
  for (std::size_t i = 0; i < count; ++i) inputs.push_back(encoderInput(coloredBlob(i)));
  return inputs;
}

void encodeObjects(benchmark::State& state) {
  const ConceptLearner network = learner();
  const auto objects = inputs(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(network.encode(objects));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(encodeObjects)->Arg(1)->Arg(64)->Name("objects encoded")->UseRealTime();

/// A floor of boards with a grain, 2 m away, and an object of 40 x 40 pixels.
RgbdImage boardedFloor(int width, int height) {
  const auto pixels = static_cast<std::size_t>(width * height);
  RgbdImage image{width, height, {}, {}, {}};
  image.depth_m.assign(pixels, 2.0F);
  image.mask.assign(pixels, 0);
  std::mt19937 generator(1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto grain = static_cast<int>(generator() % 16);
      image.rgb.insert(image.rgb.end(), 3,
                       static_cast<std::uint8_t>(100 + 30 * (x / 24 % 2) + grain));
      if (y >= 70 && y < 110 && x >= 70 && x < 110)
        image.mask[static_cast<std::size_t>(y * width + x)] = 1;
    }
  return image;
}

/// The steps of plans of four, causal transition, object and frame, of width x height, and the
/// floor behind the object of each plan, which its steps share; as many plans at once as asked.
void drawFrames(benchmark::State& state) {
  const ConceptLearner network = learner();
  NamedTensors tensors = tensorsOf(*CausalTransition(), "transition.");
  tensors.merge(tensorsOf(*FrameSynthesizer(), "synthesizer."));
  const VisualTransition transition(tensors, "benchmark");
  const RgbdImage image =
      boardedFloor(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const auto plans = static_cast<std::size_t>(state.range(2));
  const std::vector<Tokens> first = network.encode(inputs(plans));
  constexpr std::size_t kSteps = 4;
  for (auto _ : state) {
    std::vector<Tokens> last = first, predicted;
    for (std::size_t step = 0; step < kSteps; ++step) {
      std::vector<TransitionInput> steps;
      for (const Tokens& tokens : last)
        steps.push_back({tokens, Tokens::Zero(), Action::kMoveRight});
      last = transition.apply(steps);
      predicted.insert(predicted.end(), last.begin(), last.end());
    }
    std::vector<Background> backgrounds;
    for (std::size_t plan = 0; plan < plans; ++plan)
      backgrounds.push_back(backgroundWithout(image, 1));
    std::vector<DrawnObject> objects = network.draw(predicted);
    std::vector<SynthesisInput> frames;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      objects[i].location = {-0.7F, -0.5F, 0};  // pixel (58, 64)
      frames.push_back({backgrounds[i % plans], 1, objects[i]});
    }
    benchmark::DoNotOptimize(transition.synthesize(frames));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(kSteps * plans) * state.iterations());
}
BENCHMARK(drawFrames)
    ->ArgNames({"width", "height", "plans"})
    ->Args({128, 128, 1})
    ->Args({128, 128, 8})
    ->Args({kFrameWidth, kFrameHeight, 1})
    ->Args({kFrameWidth, kFrameHeight, 8})
    ->Name("frames drawn")
    ->UseRealTime();

/// The products of the convolutions of the encoder as matrices, [rows, inner] x [inner, columns].
struct Product {
  std::int64_t rows, inner, columns;
};

/// The least of several runs.
double secondsOfProducts(std::int64_t images) {
  const std::vector<Product> encoder{{images * 32 * 32, 5 * 16, 32}, {images * 16 * 16, 32 * 9, 64},
                                     {images * 64, 64 * 9, 96},      {images * 64, 96 * 9, 96},
                                     {images * 64, 96 * 9, 96},      {images * 64, 96 * 9, 96},
                                     {images * 64, 96 * 9, 96}};
  constexpr int kRuns = 5;
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < kRuns; ++run) {
    double seconds = 0;
    for (const Product& product : encoder) {
      const auto a = torch::rand({product.rows, product.inner});
      const auto b = torch::rand({product.inner, product.columns});
      const auto begin = std::chrono::steady_clock::now();
      const auto c = torch::mm(a, b);                            // forward
      benchmark::DoNotOptimize(torch::mm(c, b.t()).data_ptr());  // gradient of the input
      benchmark::DoNotOptimize(torch::mm(a.t(), c).data_ptr());  // gradient of the weight
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    least = std::min(least, seconds);
  }
  return least;
}

/// Training pictures that differ in colour and size.
ConceptImages trainingImages() {
  ConceptImages images;
  for (std::uint8_t color = 0; color < 6; ++color)
    for (std::uint8_t size = 0; size < 4; ++size)
      images.add(encoderInput(coloredBlob(color, 8 + 4 * size)), {0, 0, 0, 0, color, size});
  return images;
}

/// Steps of a trainer, with so many examples each. @returns seconds in all
template <typename Trainer>
double measureSteps(benchmark::State& state, Trainer& trainer, std::int64_t examples) {
  trainer.step();
  double seconds = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    trainer.step();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  state.SetItemsProcessed(state.iterations() * examples);
  return seconds;
}

constexpr std::int64_t kPairsOfChain = static_cast<std::int64_t>(kNumConcepts);

/// The first phase before the decoder joins, beside the encoder's matrix products.
void trainTokens(benchmark::State& state) {
  const ConceptImages images = trainingImages();
  const ConceptTrainingOptions options;
  ConceptTrainer trainer(images, options);
  const double seconds = measureSteps(state, trainer, options.chains * kPairsOfChain);
  const double products = secondsOfProducts(7 * options.chains);
  state.counters["share of matrix products' rate"] =
      products * static_cast<double>(state.iterations()) / seconds;
}
BENCHMARK(trainTokens)->Name("training pairs, tokens")->UseRealTime()->Iterations(10);

/// The first phase with the decoder.
void trainWithDecoder(benchmark::State& state) {
  const ConceptImages images = trainingImages();
  ConceptTrainingOptions options;
  options.reconstruction_start = 0;
  ConceptTrainer trainer(images, options);
  measureSteps(state, trainer, options.chains * kPairsOfChain);
}
BENCHMARK(trainWithDecoder)
    ->Name("training pairs, tokens and decoder")
    ->UseRealTime()
    ->Iterations(10);

/// The third phase; with settled boxes, where drawn objects are read again, or not yet.
void trainDrawer(benchmark::State& state) {
  const ConceptImages images = trainingImages();
  ConceptTrainingOptions options;
  options.encoder_steps = options.sharpening_steps = 0;
  options.settling = state.range(0) != 0 ? 0 : 1;
  ConceptTrainer trainer(images, options);
  measureSteps(state, trainer, options.reconstructed_pairs);
}
BENCHMARK(trainDrawer)
    ->ArgName("settled")
    ->Arg(0)
    ->Arg(1)
    ->Name("training pairs, drawer")
    ->UseRealTime()
    ->Iterations(10);

/// Either phase of ViCT: pairs of tokens, or windows.
void trainVict(benchmark::State& state) {
  const ConceptLearner network = learner();
  const std::vector<Tokens> tokens = network.encode(inputs(2));
  const std::vector<TaskSequence> sequences{
      {{squareFrame(100, tokens[0]), squareFrame(140, tokens[1])},
       {Action::kMoveRight},
       {Tokens::Zero()}}};
  VictTrainingOptions options;
  const bool windows = state.range(0) != 0;
  if (windows) options.transition_steps = 0;
  VictTrainer trainer(sequences, network, options);
  measureSteps(state, trainer, windows ? options.synthesis_batch : options.transition_batch);
}
BENCHMARK(trainVict)
    ->ArgName("windows")
    ->Arg(0)
    ->Arg(1)
    ->Name("training pairs, ViCT")
    ->UseRealTime()
    ->Iterations(10);

}  // namespace
}  // namespace conceptplan
