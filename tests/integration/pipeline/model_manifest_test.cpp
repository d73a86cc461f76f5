#include "conceptplan/pipeline/model_manifest.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "integration/pipeline/temporary_folder.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

ModelManifest sample() {
  ModelManifest manifest;
  manifest.name = "m";
  manifest.profile = "cpu";
  manifest.seed = 7;
  manifest.revision = "abc";
  manifest.data = {{"tasks-train", "01234567"}};
  manifest.stages = {TrainingStage::kLearnConcepts, TrainingStage::kMakeSymbols};
  manifest.measures = {{"validation/accuracy/TYPE", 0.5}};
  return manifest;
}

void writeSample(const std::filesystem::path& folder) {
  writeFileAtomically(folder / kConceptsFile, "concepts");
  writeFileAtomically(folder / kSymbolsFile, "symbols");
  writeModelManifest(folder, sample());
}

TEST(ModelManifest, ReadsWhatItWrote) {
  const TemporaryFolder folder;
  writeSample(folder.path());
  const ModelManifest read = readModelManifest(folder.path());
  EXPECT_EQ(read.name, "m");
  EXPECT_EQ(read.seed, 7U);
  EXPECT_EQ(read.data, sample().data);
  EXPECT_EQ(read.measures, sample().measures);
  EXPECT_EQ(read.stages, sample().stages);
  EXPECT_TRUE(read.has(TrainingStage::kMakeSymbols));
  EXPECT_FALSE(read.has(TrainingStage::kTrainVict));
}

TEST(ModelManifest, FindsAFlippedByteAndAMissingFileAtOnce) {
  const TemporaryFolder folder;
  writeSample(folder.path());
  writeFileAtomically(folder.path() / kConceptsFile, "concepus");
  std::filesystem::remove(folder.path() / kSymbolsFile);
  EXPECT_THAT(
      [&] { readModelManifest(folder.path()); },
      ThrowsMessage<InputError>(testing::AllOf(HasSubstr("concepts.safetensors: is damaged"),
                                               HasSubstr("symbols.safetensors"))));
}

TEST(ModelManifest, FindsAChangeToItselfWithAndWithoutItsChecksum) {
  const TemporaryFolder folder;
  writeSample(folder.path());
  const auto path = folder.path() / kModelManifestFile;
  std::string text = readFile(path);
  text.replace(text.find("0.5"), 3, "0.6");
  writeFileAtomically(path, text);
  EXPECT_THAT([&] { readModelManifest(folder.path()); },
              ThrowsMessage<InputError>(HasSubstr("manifest.json: is damaged: expected checksum")));
  const std::size_t begin = text.find("  \"checksum\"");
  text.erase(begin, text.find('\n', begin) + 1 - begin);
  writeFileAtomically(path, text);
  EXPECT_THAT([&] { readModelManifest(folder.path()); },
              ThrowsMessage<InputError>(HasSubstr("manifest.json: checksum: is missing")));
}

TEST(ModelManifest, RefusesOtherFormatsAndText) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { readModelManifest(folder.path()); },
              ThrowsMessage<InputError>(HasSubstr("manifest.json")));
  writeFileAtomically(folder.path() / "manifest.json", "{\"conceptplan_model\": 99}");
  EXPECT_THAT([&] { readModelManifest(folder.path()); },
              ThrowsMessage<InputError>(HasSubstr("expected format 5, found 99")));
  writeFileAtomically(folder.path() / "manifest.json", "{\"conceptplan_model\": 5}");
  EXPECT_THAT([&] { readModelManifest(folder.path()); },
              ThrowsMessage<InputError>(testing::AllOf(HasSubstr("profile"), HasSubstr("stages"))));
  writeFileAtomically(folder.path() / "manifest.json", "no json");
  EXPECT_THAT([&] { readModelManifest(folder.path()); },
              ThrowsMessage<InputError>(HasSubstr("not a JSON object")));
}

}  // namespace
}  // namespace conceptplan
