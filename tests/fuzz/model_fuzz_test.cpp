#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/visual_transition.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "domain/files/temporary_folder.hpp"
#include "fuzz/damage.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;

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

TEST(ModelFuzz, DamagedManifestsAreRefusedOrWhole) {
  const TemporaryFolder folder;
  writeFileAtomically(folder / kConceptsFile, "concepts");
  ModelManifest manifest;
  manifest.name = "m";
  manifest.stages = {TrainingStage::kLearnConcepts};
  manifest.measures = {{"validation/dci", 0.5}};
  writeModelManifest(folder.path(), manifest);
  std::size_t refused = 0;
  testing::forEachDamage(readFile(folder / "manifest.json"), 1000, 2000, 23,
                         [&](const std::string& bytes, const std::string& what) {
                           SCOPED_TRACE(what);
                           folder.write("manifest.json", bytes);
                           try {
                             const ModelManifest read = readModelManifest(folder.path());
                             EXPECT_LE(read.stages.size(), 1U);
                             EXPECT_LE(read.files.size(), read.stages.size());
                           } catch (const InputError&) {
                             ++refused;
                           }
                         });
  EXPECT_GT(refused, 1500U);
  folder.write("manifest.json", std::string(300'000, '['));
  EXPECT_THROW(readModelManifest(folder.path()), InputError);
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

}  // namespace
}  // namespace conceptplan
