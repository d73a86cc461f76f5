#include <gmock/gmock.h>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset_writer.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "fuzz/damage.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kPixels = std::size_t{ObjectCrop::kEdge} * ObjectCrop::kEdge;
constexpr ConceptDatasetOptions kOptions{.split = Split::kValidation, .samples = 1, .seed = 5};

ObjectCrop cropOf(const ObjectState& object) {
  ObjectCrop crop;
  crop.rgb.assign(kPixels * 3, static_cast<std::uint8_t>(object.color));
  crop.depth_m.assign(kPixels, 0);
  crop.mask.assign(kPixels, 0);
  crop.depth_m[index(combinationOf(object)) % kPixels] = 2;
  crop.mask[index(combinationOf(object)) % kPixels] = 1;
  return crop;
}

void writeConcepts(const std::filesystem::path& folder) {
  const ConceptDatasetWriter writer(folder, kOptions);
  for (const std::size_t shard : writer.pendingShards()) {
    std::vector<ObjectCrop> crops;
    for (const auto& request : writer.requests(shard)) crops.push_back(cropOf(request.object));
    writer.write(shard, crops);
  }
  writer.finish();
}

/// Reads the last samples, those of shard 1, and expects each to be refused or as it was written.
std::size_t refusedSamples(const std::filesystem::path& folder) {
  std::size_t refused = 0;
  const ConceptDataset dataset(folder);
  for (std::size_t i = 960; i < dataset.size(); i += 24) try {
      const ConceptSample sample = dataset.sample(i);
      EXPECT_EQ(combinationOf(sample.object), dataset.combinations()[i]);
      EXPECT_EQ(sample.crop.mask, cropOf(sample.object).mask);
      EXPECT_EQ(sample.crop.rgb, cropOf(sample.object).rgb);
    } catch (const InputError&) {
      ++refused;
    }
  return refused;
}

TEST(ConceptDatasetFuzz, DamagedShardsNeverShowWrongPictures) {
  const TemporaryFolder folder;
  writeConcepts(folder.path());
  const auto shard = folder / "concepts-00001.bin";
  std::size_t refused = 0;
  testing::forEachDamage(readFile(shard), 8, 40, 7,
                         [&](const std::string& bytes, const std::string& what) {
                           SCOPED_TRACE(what);
                           folder.write("concepts-00001.bin", bytes);
                           try {
                             refused += refusedSamples(folder.path());
                           } catch (const InputError&) {
                             ++refused;  // of another length
                           }
                         });
  EXPECT_GT(refused, 20U);
}

TEST(ConceptDatasetFuzz, RecordsThatChangedPlacesAreFound) {
  const TemporaryFolder folder;
  writeConcepts(folder.path());
  std::string bytes = readFile(folder / "concepts-00001.bin");
  const std::size_t record = (bytes.size() - 32) / 192;
  std::swap_ranges(bytes.begin() + 32, bytes.begin() + 32 + static_cast<std::ptrdiff_t>(record),
                   bytes.begin() + 32 + static_cast<std::ptrdiff_t>(record));
  folder.write("concepts-00001.bin", bytes);
  const ConceptDataset dataset(folder.path());
  EXPECT_THAT(faultsOf([&] { dataset.sample(960); }),
              HasSubstr("record 0 shows another object than belongs there"));
  EXPECT_NO_THROW(dataset.sample(962));
}

TEST(DatasetFuzz, DamagedManifestsAreRefusedOrSayTheSame) {
  const TemporaryFolder folder;
  writeConcepts(folder.path());
  testing::forEachDamage(readFile(folder / "dataset.json"), 1000, 500, 11,
                         [&](const std::string& bytes, const std::string& what) {
                           SCOPED_TRACE(what);
                           folder.write("dataset.json", bytes);
                           try {
                             EXPECT_EQ(ConceptDataset(folder.path()).options(), kOptions);
                           } catch (const InputError&) {
                           }
                         });
  folder.write("dataset.json", std::string(300'000, '['));
  EXPECT_THAT(faultsOf([&] { ConceptDataset{folder.path()}; }), HasSubstr("nested too deeply"));
}

TEST(TaskDatasetFuzz, AnyDamageToTasksIsFound) {
  const TemporaryFolder folder;
  TaskDatasetOptions options;
  options.levels = {4};
  options.count = 5;
  options.frames = Frames::kNone;
  TaskDatasetWriter(folder.path(), options).finish();
  for (const char* file : {"tasks.jsonl", "checksums.txt"}) {
    const std::string whole = readFile(folder / file);
    testing::forEachDamage(whole, 200, 300, 13,
                           [&](const std::string& bytes, const std::string& what) {
                             SCOPED_TRACE(std::string(file) + ", " + what);
                             folder.write(file, bytes);
                             EXPECT_THROW(TaskDataset{folder.path()}, InputError);
                           });
    folder.write(file, whole);
  }
  EXPECT_EQ(TaskDataset(folder.path()).tasks().size(), 5U);
}

/// Pictures stay on disk until they are asked for; a damaged one is refused then, though it may be
/// a picture still.
TEST(TaskDatasetFuzz, DamagedPicturesAreRefused) {
  const TemporaryFolder folder;
  TaskDatasetOptions options;
  options.count = 1;
  options.frames = Frames::kEnds;
  const TaskDatasetWriter writer(folder.path(), options);
  for (const auto& frame : writer.pendingFrames())
    writer.write(frame, {2, 1, {9, 1, 2, 3, 4, 5}, {1.25F, 2.5F}, {0, 1}});
  writer.finish();
  const TaskDataset dataset(folder.path());
  const Task& task = dataset.tasks().front();
  const auto goal = static_cast<int>(task.reference.size());
  EXPECT_NO_THROW(dataset.frame(task, 0));
  const std::string first = "images/" + task.id + "/00.";
  for (const char* part : {"rgb.png", "depth.png", "mask.png"}) {
    const std::string file = first + part;
    const std::string whole = readFile(folder / file);
    testing::forEachDamage(
        whole, 20, 100, 17, [&](const std::string& bytes, const std::string& what) {
          SCOPED_TRACE(file + ", " + what);
          folder.write(file, bytes);
          EXPECT_THAT(faultsOf([&] { dataset.frame(task, 0); }), HasSubstr(file));
        });
    folder.write(file, whole);
  }
  writeRgbdImage(folder / "images" / task.id / "00",
                 {2, 1, {8, 1, 2, 3, 4, 5}, {1.25F, 2.5F}, {0, 1}});
  EXPECT_THAT(faultsOf([&] { dataset.frame(task, 0); }), HasSubstr("00.rgb.png: is damaged"));
  EXPECT_NO_THROW(dataset.frame(task, goal));
}

}  // namespace
}  // namespace conceptplan
