// Throughput of the concept learner and of ViCT, and of training steps beside plain matrix products
// of the same sizes.

#include <benchmark/benchmark.h>
#include <torch/torch.h>

#include <chrono>

#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/torch/causal_transition.hpp"
#include "conceptplan/learner/torch/concept_trainer.hpp"
#include "conceptplan/learner/torch/frame_synthesizer.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/visual_transition.hpp"
#include "learner/random_crops.hpp"

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

/// The steps of a plan of four, causal transition, object and frame, of width x height, and the
/// floor behind the object, which they share.
void drawFrames(benchmark::State& state) {
  const ConceptLearner network = learner();
  NamedTensors tensors = tensorsOf(*CausalTransition(), "transition.");
  tensors.merge(tensorsOf(*FrameSynthesizer(), "synthesizer."));
  const VisualTransition transition(tensors, "benchmark");
  const int width = static_cast<int>(state.range(0)), height = static_cast<int>(state.range(1));
  const auto pixels = static_cast<std::size_t>(width * height);
  RgbdImage image{width, height, {}, {}, {}};
  image.rgb.assign(3 * pixels, 128);
  image.depth_m.assign(pixels, 2.0F);
  image.mask.assign(pixels, 0);
  for (int y = 70; y < 110; ++y)
    for (int x = 70; x < 110; ++x) image.mask[static_cast<std::size_t>(y * width + x)] = 1;
  const Tokens tokens = network.encode(inputs(1)).front();
  constexpr int kSteps = 4;
  for (auto _ : state) {
    std::vector<Tokens> predicted{tokens};
    for (int step = 0; step < kSteps; ++step)
      predicted.push_back(transition.apply(predicted.back(), Tokens::Zero(), Action::kMoveRight));
    const Background background = backgroundWithout(image, 1);
    for (DrawnObject& object : network.draw(std::span(predicted).subspan(1))) {
      object.location = {-0.7F, -0.5F, 0};  // pixel (58, 64)
      benchmark::DoNotOptimize(transition.synthesize(background, 1, object));
    }
  }
  state.SetItemsProcessed(kSteps * state.iterations());
}
BENCHMARK(drawFrames)
    ->Args({128, 128})
    ->Args({kFrameWidth, kFrameHeight})
    ->Name("frames drawn")
    ->UseRealTime();

/// The products of the convolutions of the encoder as matrices, [rows, inner] x [inner, columns].
struct Product {
  std::int64_t rows, inner, columns;
};

double secondsOfProducts(std::int64_t images) {
  const std::vector<Product> encoder{{images * 32 * 32, 5 * 16, 32}, {images * 16 * 16, 32 * 9, 64},
                                     {images * 64, 64 * 9, 96},      {images * 64, 96 * 9, 96},
                                     {images * 64, 96 * 9, 96},      {images * 64, 96 * 9, 96},
                                     {images * 64, 96 * 9, 96}};
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
  return seconds;
}

/// A step of the first phase: no decoder.
void trainingStep(benchmark::State& state) {
  ConceptImages images;
  for (std::uint8_t color = 0; color < 6; ++color)
    for (std::uint8_t size = 0; size < 4; ++size)
      images.add(encoderInput(coloredBlob(color, 8 + 4 * size)), {0, 0, 0, 0, color, size});
  const ConceptTrainingOptions options;
  ConceptTrainer trainer(images, options);
  trainer.step();
  double seconds = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    trainer.step();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  const std::int64_t pairs = options.chains * static_cast<std::int64_t>(kNumConcepts);
  state.SetItemsProcessed(state.iterations() * pairs);
  secondsOfProducts(7 * options.chains);
  const double products = secondsOfProducts(7 * options.chains);
  state.counters["share of matrix products' rate"] =
      products * static_cast<double>(state.iterations()) / seconds;
}
BENCHMARK(trainingStep)->Name("training pairs")->UseRealTime()->Iterations(10);

}  // namespace
}  // namespace conceptplan
