#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/visual_transition.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "domain/dataset/reseal.hpp"
#include "domain/files/temporary_folder.hpp"
#include "fuzz/damage.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kFrameSize = static_cast<std::size_t>(kFrameWidth) * kFrameHeight;
const std::filesystem::path kShipped = CONCEPTPLAN_SHIPPED_MODEL;

TEST(ModelFuzz, DamageToAnyFileIsFoundByTheManifest) {
  const TemporaryFolder folder;
  std::filesystem::copy(kShipped, folder.path(), std::filesystem::copy_options::recursive);
  for (const char* file : {kConceptsFile, kSymbolsFile, kTransitionsFile, kVictFile}) {
    const std::string whole = readFile(folder / file);
    testing::forEachDamage(
        whole, 6, 12, 19, [&](const std::string& bytes, const std::string& what) {
          SCOPED_TRACE(std::string(file) + ", " + what);
          folder.write(file, bytes);
          EXPECT_THAT(faultsOf([&] { readModelManifest(folder.path()); }), HasSubstr(file));
        });
    folder.write(file, whole);
  }
  EXPECT_NO_THROW(readModelManifest(folder.path()));
}

/// A manifest and the file of its one stage.
ModelManifest writeSmallModel(const TemporaryFolder& folder) {
  writeFileAtomically(folder / kConceptsFile, "concepts");
  ModelManifest manifest;
  manifest.name = "m";
  manifest.stages = {TrainingStage::kLearnConcepts};
  manifest.measures = {{"validation/dci", 0.5}};
  writeModelManifest(folder.path(), manifest);
  return manifest;
}

TEST(ModelFuzz, DamagedManifestsAreRefusedOrSayTheSame) {
  const TemporaryFolder folder;
  const ModelManifest manifest = writeSmallModel(folder);
  std::size_t refused = 0;
  testing::forEachDamage(readFile(folder / "manifest.json"), 1000, 2000, 23,
                         [&](const std::string& bytes, const std::string& what) {
                           SCOPED_TRACE(what);
                           folder.write("manifest.json", bytes);
                           try {
                             const ModelManifest read = readModelManifest(folder.path());
                             EXPECT_EQ(read.name, manifest.name);
                             EXPECT_EQ(read.seed, manifest.seed);
                             EXPECT_EQ(read.stages, manifest.stages);
                             EXPECT_EQ(read.measures, manifest.measures);
                           } catch (const InputError&) {
                             ++refused;
                           }
                         });
  EXPECT_GT(refused, 1500U);
  folder.write("manifest.json", std::string(300'000, '['));
  EXPECT_THROW(readModelManifest(folder.path()), InputError);
}

TEST(ModelFuzz, ResealedManifestsAreRefusedOrNameTheirFiles) {
  const TemporaryFolder folder;
  const ModelManifest manifest = writeSmallModel(folder);
  std::size_t refused = 0, read = 0;
  testing::forEachDamage(readFile(folder / "manifest.json"), 1000, 2000, 53,
                         [&](const std::string& bytes, const std::string& what) {
                           SCOPED_TRACE(what);
                           folder.write("manifest.json", bytes);
                           resealJson(folder / "manifest.json");
                           try {
                             const ModelManifest found = readModelManifest(folder.path());
                             EXPECT_EQ(found.files.size(), found.stages.size());
                             ++read;
                           } catch (const InputError&) {
                             ++refused;
                           }
                         });
  EXPECT_GT(refused, 0U);
  EXPECT_GT(read, 0U);
}

/// Tensors of a shipped file with one of them changed, every eighth, as if the checksums fitted.
template <typename Network>
void expectRefusal(const char* file, const Network& network) {
  const NamedTensors good = decodeTensors(readFile(kShipped / file), file);
  EXPECT_NO_THROW(network(good));
  std::size_t i = 0;
  for (const auto& [name, tensor] : good) {
    if (i++ % 8 != 0) continue;
    NamedTensors changed = good;
    changed.erase(name);
    EXPECT_THAT(faultsOf([&] { network(changed); }), HasSubstr(name));
    changed[name] = {{static_cast<std::int64_t>(tensor.values.size()), 1}, tensor.values};
    EXPECT_THAT(faultsOf([&] { network(changed); }), HasSubstr("expected shape"));
    changed[name] = {{0}, {}};
    EXPECT_THAT(faultsOf([&] { network(changed); }), HasSubstr("expected shape"));
  }
}

TEST(ModelFuzz, NetworksOfMissingOrMisshapenTensorsAreRefused) {
  const EncoderKind encoder = readModelManifest(kShipped).encoder;
  expectRefusal(kConceptsFile,
                [&](const NamedTensors& tensors) { ConceptLearner(tensors, encoder, "m"); });
  expectRefusal(kVictFile, [](const NamedTensors& tensors) { VisualTransition(tensors, "m"); });
}

/// A grey floor with a disc, as instance 1.
RgbdImage pictureOfADisc() {
  RgbdImage image{kFrameWidth, kFrameHeight, std::vector<std::uint8_t>(3 * kFrameSize, 150),
                  std::vector<float>(kFrameSize, 2.0F), std::vector<std::uint8_t>(kFrameSize, 0)};
  for (int y = -16; y <= 16; ++y)
    for (int x = -16; x <= 16; ++x) {
      if (x * x + y * y > 256) continue;
      const auto pixel = static_cast<std::size_t>((130 + y) * kFrameWidth + 190 + x);
      image.mask[pixel] = 1;
      image.depth_m[pixel] = 1.95F;
      image.rgb[3 * pixel] = 220;
    }
  return image;
}

/// Reads the disc and draws it after a step; all numbers are finite, or an InputError tells why
/// not.
/// @returns whether all went well.
bool perceivesAndRenders(const std::filesystem::path& folder) {
  const Model model(folder);
  const RgbdImage picture = pictureOfADisc();
  try {
    const Percept percept = model.perceive(picture);
    for (const SymbolBelief& belief : percept.beliefs)
      for (const auto& of_concept : belief)
        for (const double p : of_concept) EXPECT_TRUE(p >= 0 && p <= 1) << p;
    Plan plan;
    plan.actions = {Action::kMoveRight, Action::kChangeColor};
    plan.predicted.assign(2, mostProbable(percept.beliefs.front()));
    for (const RgbdImage& frame : model.render(picture, percept, 1, plan))
      EXPECT_TRUE(std::ranges::all_of(frame.depth_m, [](float d) { return std::isfinite(d); }));
    return true;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("not finite"));
    return false;
  }
}

/// Half-precision files can hold these numbers, and checksums can fit.
TEST(ModelFuzz, HugeWeightsGiveAnErrorOrFinitePictures) {
  constexpr float kLargest = 65504;
  const TemporaryFolder folder;
  std::filesystem::copy(kShipped, folder.path(), std::filesystem::copy_options::recursive);
  const ModelManifest manifest = readModelManifest(folder.path());
  EXPECT_TRUE(perceivesAndRenders(folder.path()));
  std::mt19937_64 generator(29);
  int errors = 0, pictures = 0;
  for (const char* file : {kConceptsFile, kVictFile}) {
    const std::string whole = readFile(kShipped / file);
    const NamedTensors good = decodeTensors(whole, file);
    for (int change = 0; change < 12; ++change) {
      SCOPED_TRACE(std::string(file) + ", change " + std::to_string(change));
      NamedTensors changed = good;
      for (auto& [name, tensor] : changed) {
        // All of them; then about a sixth, with signs of their own or of their tensor.
        if (change > 1 && generator() % 6 != 0) continue;
        const bool together = change % 2 == 0;
        const float sign = generator() % 2 == 0 ? kLargest : -kLargest;
        for (float& value : tensor.values)
          value = together ? sign : generator() % 2 == 0 ? kLargest : -kLargest;
      }
      folder.write(file, encodeTensors(changed, TensorPrecision::kFloat16));
      writeModelManifest(folder.path(), manifest);
      ++(perceivesAndRenders(folder.path()) ? pictures : errors);
    }
    folder.write(file, whole);
  }
  EXPECT_GT(errors, 0);
  EXPECT_GT(pictures, 0);
}

}  // namespace
}  // namespace conceptplan
