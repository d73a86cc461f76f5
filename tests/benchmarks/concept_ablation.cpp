// Trains the concept network for a few steps, once for each way of doing it, and prints how many
// validation pictures are read right by K-means on its tokens: what each part of the way is worth.
// concept_ablation DATA STEPS SEED [WAY...], where DATA is the folder of data of a training, or has
// concepts-train and concepts-validation of `conceptplan generate concepts`.
#include <torch/torch.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>
#include <string>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/kmeans.hpp"
#include "conceptplan/learner/symbolizer.hpp"
#include "conceptplan/learner/torch/concept_trainer.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"

using namespace conceptplan;

namespace {

struct Way {
  const char* name;
  std::function<void(ConceptTrainingOptions&)> changes;
  std::function<void(EncoderInput&)> hides = nullptr;  ///< a part of what is seen
};

void hideDepth(EncoderInput& input) {
  std::fill_n(input.planes.begin() + EncoderInput::kDepthPlane * EncoderInput::kPixels,
              EncoderInput::kPixels, 0);
}

/// The profile `cpu`, and what each of the others lacks or does instead.
const std::vector<Way>& ways() {
  using Options = ConceptTrainingOptions;
  static const std::vector<Way> kWays{
      {"cpu", [](Options&) {}},
      {"no depth", [](Options&) {}, hideDepth},
      {"no place", [](Options&) {}, [](auto& in) { in.location = {}; }},
      {"no variation", [](Options& o) { o.augmentation = kNoAugmentation; }},
      {"no averaging", [](Options& o) { o.averaging = 0; }},
      {"no decoder", [](Options& o) { o.reconstruction_start = 1; }},
      {"decoder at once", [](Options& o) { o.reconstruction_start = 0; }},
      {"all pixels alike", [](Options& o) { o.foreground_weight = 1; }},
      {"no Eq. (2)", [](Options& o) { o.disentangling_weight = 0; }},
      {"no likelihood", [](Options& o) { o.pair_weight = o.use_weight = o.confidence_weight = 0; }},
      {"less even use", [](Options& o) { o.use_weight = 0.5; }},
      {"no revival", [](Options& o) { o.revival_interval = o.encoder_steps + o.sharpening_steps; }},
      {"no certainty", [](Options& o) { o.confidence_weight = 0; }},
      {"half the rate", [](Options& o) { o.learning_rate /= 2; }},
      {"a third of chains", [](Options& o) { o.chains /= 3; }},
      // The last, as each of its steps takes many times as long.
      {"whole frames", [](Options& o) { o.encoder = EncoderKind::kFullFrame; }}};
  return kWays;
}

struct Pictures {
  std::vector<EncoderInput> inputs;
  std::vector<ConceptValues> values;
};

/// Up to `most`, evenly spread over the set.
Pictures picturesOf(const std::filesystem::path& folder, std::size_t most,
                    const std::function<void(EncoderInput&)>& hides) {
  const ConceptDataset data(folder);
  const std::size_t count = std::min(most, data.size());
  Pictures pictures;
  for (std::size_t i = 0; i < count; ++i) {
    const ConceptSample sample = data.sample(i * data.size() / count);
    pictures.inputs.push_back(encoderInput(sample.crop));
    if (hides) hides(pictures.inputs.back());
    pictures.values.push_back(conceptValues(sample.object));
  }
  return pictures;
}

/// Share of pictures read right: of each concept, and of all six.
using Shares = std::array<double, kNumConcepts + 1>;

/// What K-means makes of tokens of training pictures, for one concept.
struct NamedClusters {
  SymbolClusters clusters;
  std::vector<std::size_t> values;  ///< that most pictures of each cluster show
};

std::size_t nearest(const SymbolClusters& clusters, const Tokens& tokens, Concept which) {
  Eigen::Index symbol = 0;
  squaredDistances(clusters, tokens.row(static_cast<Eigen::Index>(index(which)))).minCoeff(&symbol);
  return static_cast<std::size_t>(symbol);
}

std::vector<NamedClusters> clustersOf(const ConceptLearner& learner, const Pictures& train,
                                      std::uint64_t seed) {
  const std::vector<Tokens> tokens = learner.encode(train.inputs);
  KMeansOptions options;
  options.seed = seed;
  std::vector<NamedClusters> named;
  for (const Concept which : kConcepts) {
    const std::size_t values = kConceptCardinality[index(which)];
    const SymbolClusters clusters{kMeans(tokensOf(tokens, which), values, options).centers};
    std::vector<std::vector<int>> votes(values, std::vector<int>(values, 0));
    for (std::size_t i = 0; i < tokens.size(); ++i)
      ++votes[nearest(clusters, tokens[i], which)][train.values[i][index(which)]];
    std::vector<std::size_t> winners;
    for (const std::vector<int>& of_symbol : votes)
      winners.push_back(static_cast<std::size_t>(
          std::max_element(of_symbol.begin(), of_symbol.end()) - of_symbol.begin()));
    named.push_back({clusters, winners});
  }
  return named;
}

Shares readRight(const ConceptLearner& learner, const std::vector<NamedClusters>& named,
                 const Pictures& pictures) {
  const std::vector<Tokens> tokens = learner.encode(pictures.inputs);
  Shares right{};
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    bool all = true;
    for (const Concept which : kConcepts) {
      const auto& [clusters, values] = named[index(which)];
      const bool one =
          values[nearest(clusters, tokens[i], which)] == pictures.values[i][index(which)];
      right[index(which)] += one ? 1 : 0;
      all = all && one;
    }
    right[kNumConcepts] += all ? 1 : 0;
  }
  for (double& share : right) share /= static_cast<double>(tokens.size());
  return right;
}

void print(const Shares& shares) {
  for (const double share : shares) std::printf(" %5.1f", 100 * share);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::fprintf(stderr, "expected: concept_ablation DATA STEPS SEED [WAY...]\n");
    return 2;
  }
  const std::filesystem::path data = argv[1];
  const std::int64_t steps = std::max(10L, std::atol(argv[2]));
  const auto seed = static_cast<std::uint64_t>(std::atoll(argv[3]));
  std::set<std::string> wanted(argv + 4, argv + argc);
  const bool wants_all = wanted.empty();
  std::printf(
      "%lld steps, seed %llu, %d threads; share in %% of validation pictures read right, "
      "plain and varied as in training\n%-18s",
      static_cast<long long>(steps), static_cast<unsigned long long>(seed),
      torch::get_num_threads(), "");
  for (int set = 0; set < 2; ++set) {
    for (const char* column : {"TYPE", "X", "Y", "ROT.", "COLOR", "SIZE", "all"})
      std::printf(" %5s", column);
  }
  std::printf("\n");
  for (const Way& way : ways()) {
    if (!wants_all && wanted.erase(way.name) == 0) continue;
    const Pictures train = picturesOf(data / "concepts-train", SIZE_MAX, way.hides);
    const Pictures clustered = picturesOf(data / "concepts-train", 4'000, way.hides);
    const Pictures plain = picturesOf(data / "concepts-validation", 1'000, way.hides);
    ConceptTrainingOptions options;
    options.seed = seed;
    options.sharpening_steps = steps / 5;
    options.encoder_steps = steps - options.sharpening_steps;
    options.drawer_steps = 0;
    options.most_repairs = 0;  // each way has the same number of steps
    Pictures varied = plain;
    std::mt19937_64 generator(seed);
    for (EncoderInput& input : varied.inputs)
      input = augmented(input.planes, input.location,
                        plain.inputs[generator() % plain.inputs.size()].planes,
                        options.augmentation, generator);
    way.changes(options);
    ConceptImages images;
    for (std::size_t i = 0; i < train.inputs.size(); ++i)
      images.add(train.inputs[i], train.values[i]);
    ConceptTrainer trainer(images, options);
    while (trainer.stepsDone() < trainer.stepsInAll()) trainer.step();
    const ConceptLearner learner(tensorsOf(*trainer.averaged(), "concepts."), options.encoder,
                                 "ablation");
    std::printf("%-18s", way.name);
    const std::vector<NamedClusters> named = clustersOf(learner, clustered, seed);
    print(readRight(learner, named, plain));
    print(readRight(learner, named, varied));
    std::printf("\n");
    std::fflush(stdout);
  }
  for (const std::string& unknown : wanted)
    std::fprintf(stderr, "unknown way \"%s\"\n", unknown.c_str());
  return wanted.empty() ? 0 : 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
