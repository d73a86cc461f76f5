#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <random>
#include <regex>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset_writer.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "domain/dataset/reseal.hpp"
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

TEST(ConceptDatasetFuzz, ResealedRecordsAreRefusedOrHaveAPixel) {
  const TemporaryFolder folder;
  writeConcepts(folder.path());
  const std::string whole = readFile(folder / "concepts-00001.bin");
  std::size_t refused = 0, read = 0;
  testing::forEachDamage(whole.substr(kRecordsBegin, kRecordBytes), 40, 400, 31,
                         [&](const std::string& record, const std::string& what) {
                           SCOPED_TRACE(what);
                           std::string bytes = whole, fitted = record;
                           fitted.resize(kRecordBytes, '\0');
                           bytes.replace(kRecordsBegin, kRecordBytes, fitted);
                           resealRecord(bytes, 0);
                           folder.write("concepts-00001.bin", bytes);
                           const ConceptDataset dataset(folder.path());
                           try {
                             const ConceptSample sample = dataset.sample(960);
                             EXPECT_EQ(combinationOf(sample.object), dataset.combinations()[960]);
                             EXPECT_GT(std::ranges::count(sample.crop.mask, 1), 0);
                             ++read;
                           } catch (const InputError&) {
                             ++refused;
                           }
                         });
  EXPECT_GT(refused, 0U);
  EXPECT_GT(read, 0U);
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

TEST(DatasetFuzz, ResealedManifestsAreRefusedOrSayWhatIsPossible) {
  const TemporaryFolder folder;
  TaskDatasetOptions written;
  written.levels = {4, 2};
  written.count = 3;
  written.frames = Frames::kNone;
  TaskDatasetWriter(folder.path(), written).finish();
  std::size_t refused = 0, read = 0;
  testing::forEachDamage(readFile(folder / "dataset.json"), 1000, 2000, 37,
                         [&](const std::string& bytes, const std::string& what) {
                           SCOPED_TRACE(what);
                           folder.write("dataset.json", bytes);
                           resealJson(folder / "dataset.json");
                           try {
                             const TaskDatasetOptions options =
                                 TaskDataset(folder.path()).options();
                             EXPECT_EQ(options.levels, written.levels);
                             EXPECT_EQ(options.count, written.count);
                             ++read;
                           } catch (const InputError&) {
                             ++refused;
                           }
                         });
  EXPECT_GT(refused, 0U);
  EXPECT_GT(read, 0U);
}

/// A random number, and half of the time a name, of the text gives way to another of its kind.
std::string withOtherValues(std::string text, std::mt19937_64& generator) {
  constexpr std::array kNumbers{"0", "1", "2", "3", "254", "299", "-1", "0.2", "1e-300", "1e999"};
  constexpr std::array kNames{"move_front", "move_left", "rotate_left", "change_color",
                              "Dyer",       "Egg",       "red",         "cyan"};
  const auto replaceOne = [&](const std::regex& kind, const std::string& other) {
    const std::vector<std::smatch> found(std::sregex_iterator(text.begin(), text.end(), kind), {});
    const std::smatch& match = found[generator() % found.size()];
    text.replace(static_cast<std::size_t>(match.position(1)),
                 static_cast<std::size_t>(match.length(1)), other);
  };
  if (generator() % 2 == 0)
    replaceOne(std::regex("\"([A-Za-z_]+)\"[,\\]]"), kNames[generator() % kNames.size()]);
  replaceOne(std::regex("[:,]([0-9][0-9.]*)"), kNumbers[generator() % kNumbers.size()]);
  return text;
}

/// Whether the set is read rather than refused; what is read makes sense.
bool readsTasks(const std::filesystem::path& folder) {
  try {
    const TaskDataset dataset(folder);
    EXPECT_EQ(dataset.tasks().size(), 5U);
    for (const Task& task : dataset.tasks()) {
      EXPECT_EQ(task.level, 4);
      EXPECT_EQ(task.initial.workbench, Workbench{});
      EXPECT_LT(task.initial.target, task.initial.objects.size());
      const Replay end = replay(task.initial, task.reference);
      EXPECT_TRUE(end.succeeded());
      EXPECT_EQ(end.world.objects[task.initial.target], task.goal);
    }
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST(TaskDatasetFuzz, ResealedTasksAreRefusedOrMakeSense) {
  const TemporaryFolder folder;
  TaskDatasetOptions options;
  options.levels = {4};
  options.count = 5;
  options.frames = Frames::kNone;
  TaskDatasetWriter(folder.path(), options).finish();
  const std::string whole = readFile(folder / "tasks.jsonl");
  std::size_t refused = 0, read = 0;
  const auto check = [&](const std::string& bytes, const std::string& what) {
    SCOPED_TRACE(what);
    folder.write("tasks.jsonl", bytes);
    resealDataset(folder.path());
    ++(readsTasks(folder.path()) ? read : refused);
  };
  testing::forEachDamage(whole, 200, 500, 41, check);
  std::mt19937_64 generator(43);
  for (int change = 0; change < 500; ++change)
    check(withOtherValues(whole, generator), "values " + std::to_string(change));
  EXPECT_GT(refused, 0U);
  EXPECT_GT(read, 0U);
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

RgbdImage plainImage(std::uint8_t red) {
  constexpr std::size_t kFramePixels = std::size_t{kFrameWidth} * kFrameHeight;
  RgbdImage image{kFrameWidth, kFrameHeight, std::vector<std::uint8_t>(kFramePixels * 3, 5),
                  std::vector<float>(kFramePixels, 2.5F),
                  std::vector<std::uint8_t>(kFramePixels, 1)};
  image.rgb[0] = red;
  return image;
}

/// A set of one task with plain pictures. @returns the task's id
std::string writePlainTask(const TemporaryFolder& folder) {
  TaskDatasetOptions options;
  options.count = 1;
  options.frames = Frames::kEnds;
  const TaskDatasetWriter writer(folder.path(), options);
  for (const auto& frame : writer.pendingFrames()) writer.write(frame, plainImage(9));
  writer.finish();
  return writer.tasks().front().id;
}

/// Pictures stay on disk until they are asked for; a damaged one is refused then, though it may be
/// a picture still.
TEST(TaskDatasetFuzz, DamagedPicturesAreRefused) {
  const TemporaryFolder folder;
  writePlainTask(folder);
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
  writeRgbdImage(folder / "images" / task.id / "00", plainImage(8));
  EXPECT_THAT(faultsOf([&] { dataset.frame(task, 0); }), HasSubstr("00.rgb.png: "));
  EXPECT_NO_THROW(dataset.frame(task, goal));
}

TEST(TaskDatasetFuzz, ResealedPicturesAreRefusedOrOfTheRightSize) {
  const TemporaryFolder folder;
  const std::string first = "images/" + writePlainTask(folder) + "/00.";
  std::size_t refused = 0;
  for (const char* part : {"rgb.png", "depth.png", "mask.png"}) {
    const std::string file = first + part;
    const std::string whole = readFile(folder / file);
    testing::forEachDamage(whole, 20, 60, 47,
                           [&](const std::string& bytes, const std::string& what) {
                             SCOPED_TRACE(file + ", " + what);
                             folder.write(file, bytes);
                             resealDataset(folder.path());
                             const TaskDataset dataset(folder.path());
                             try {
                               const RgbdImage image = dataset.frame(dataset.tasks().front(), 0);
                               EXPECT_EQ(image.width, kFrameWidth);
                               EXPECT_EQ(image.height, kFrameHeight);
                             } catch (const InputError&) {
                               ++refused;
                             }
                           });
    folder.write(file, whole);
  }
  EXPECT_GT(refused, 0U);
}

}  // namespace
}  // namespace conceptplan
