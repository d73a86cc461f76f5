#include "conceptplan/domain/dataset/task_dataset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "conceptplan/domain/dataset/dataset_state.hpp"
#include "conceptplan/domain/dataset/task_dataset_writer.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;

TaskDatasetOptions smallOptions() {
  TaskDatasetOptions options;
  options.levels = {4, 1};
  options.count = 3;
  options.split = Split::kTest;
  options.frames = Frames::kNone;
  options.seed = 12;
  return options;
}

RgbdImage smallImage(std::uint8_t value) {
  return {2, 1, {value, 1, 2, 3, 4, 5}, {1.25F, 2.5F}, {0, 1}};
}

void writeDataset(const std::filesystem::path& folder, const TaskDatasetOptions& options) {
  const TaskDatasetWriter writer(folder, options);
  for (const auto& frame : writer.pendingFrames())
    writer.write(frame, smallImage(static_cast<std::uint8_t>(frame.step)));
  writer.finish();
}

void replaceInFile(const std::filesystem::path& path, const std::string& from,
                   const std::string& to) {
  std::string bytes = readFile(path);
  const std::size_t position = bytes.find(from);
  ASSERT_NE(position, std::string::npos) << path;
  writeFileAtomically(path, bytes.replace(position, from.size(), to));
}

/// Leaves a manifest as earlier versions wrote it.
void takeChecksumOut(const std::filesystem::path& path) {
  std::string text = readFile(path);
  const std::size_t begin = text.find(",\n  \"checksum\"");
  ASSERT_NE(begin, std::string::npos);
  writeFileAtomically(path, text.erase(begin, text.rfind('\n', text.size() - 2) - begin));
}

std::string readingFaults(const std::filesystem::path& folder) {
  return faultsOf([&] { TaskDataset{folder}; });
}

TEST(TaskDataset, ReadsWhatWasWritten) {
  const TemporaryFolder folder;
  TaskDatasetOptions options = smallOptions();
  options.combination = Combination::kAll;
  options.domain = RenderDomain::kShifted;
  options.objects = ObjectSet::kUnseen;
  writeDataset(folder.path(), options);
  const TaskDataset dataset(folder.path());
  EXPECT_EQ(dataset.options(), options);
  const std::vector<Task> expected = drawTasks(options);
  ASSERT_EQ(dataset.tasks().size(), 6u);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Task& task = dataset.tasks()[i];
    EXPECT_EQ(task.id, expected[i].id);
    EXPECT_EQ(task.level, expected[i].level);
    EXPECT_EQ(task.initial, expected[i].initial);
    EXPECT_EQ(task.goal, expected[i].goal);
    EXPECT_EQ(task.reference, expected[i].reference);
    EXPECT_EQ(task.appearance, expected[i].appearance);
  }
  EXPECT_EQ(dataset.tasks()[0].id, "level4-000000");
  EXPECT_EQ(dataset.tasks()[3].id, "level1-000000");
}

TEST(TaskDataset, FramesAreReadBack) {
  const TemporaryFolder folder;
  TaskDatasetOptions options = smallOptions();
  options.frames = Frames::kEnds;
  writeDataset(folder.path(), options);
  const TaskDataset dataset(folder.path());
  const Task& task = dataset.tasks()[0];
  const int last = static_cast<int>(task.reference.size());
  const RgbdImage goal = dataset.frame(task, last);
  EXPECT_EQ(goal.rgb, smallImage(static_cast<std::uint8_t>(last)).rgb);
  EXPECT_EQ(goal.mask, smallImage(0).mask);
  EXPECT_NEAR(goal.depth_m[1], 2.5, 1e-6);
  EXPECT_THAT(faultsOf([&] { dataset.frame(task, last + 1); }), HasSubstr(".rgb.png"));
}

TEST(TaskDataset, StoredStepsAreNoneTheEndsOrAll) {
  Task task;
  task.reference = {Action::kMoveFront, Action::kMoveFront};
  EXPECT_THAT(storedSteps(task, Frames::kNone), testing::IsEmpty());
  EXPECT_THAT(storedSteps(task, Frames::kEnds), testing::ElementsAre(0, 2));
  EXPECT_THAT(storedSteps(task, Frames::kAll), testing::ElementsAre(0, 1, 2));
  for (const Frames frames : {Frames::kNone, Frames::kEnds, Frames::kAll})
    EXPECT_EQ(framesNamed(name(frames)), frames);
  EXPECT_EQ(framesNamed("some"), std::nullopt);
}

TEST(TaskDataset, TheLastStepIsTheGoal) {
  for (const Task& task : drawTasks(smallOptions())) {
    EXPECT_EQ(worldAtStep(task, 0), task.initial);
    const int last = static_cast<int>(task.reference.size());
    EXPECT_EQ(worldAtStep(task, last).objects[task.initial.target], task.goal);
    EXPECT_THROW(worldAtStep(task, last + 1), std::invalid_argument);
    EXPECT_THROW(worldAtStep(task, -1), std::invalid_argument);
  }
}

TEST(TaskDataset, TheSameOptionsGiveTheSameBytes) {
  const TemporaryFolder folder;
  writeDataset(folder / "a", smallOptions());
  writeDataset(folder / "b", smallOptions());
  for (const char* file : {"dataset.json", "tasks.jsonl", "checksums.txt"})
    EXPECT_EQ(readFile(folder / "a" / file), readFile(folder / "b" / file));
}

TEST(TaskDataset, DrawsAreThoseOfTheGenerator) {
  const std::vector<Task> tasks = drawTasks(smallOptions());
  const TaskGenerator generator({.level = 1, .split = Split::kTest, .seed = 12});
  EXPECT_EQ(tasks[5].initial, generator.task(2).initial);
}

TEST(TaskDataset, WrongOptionsAreNamed) {
  TaskDatasetOptions options;
  options.levels = {1, 2, 1};
  EXPECT_THAT([&] { drawTasks(options); },
              testing::ThrowsMessage<std::invalid_argument>("level 1 is named twice"));
  options.levels = {};
  EXPECT_THROW(drawTasks(options), std::invalid_argument);
  options.levels = {5};
  EXPECT_THROW(drawTasks(options), std::invalid_argument);
  options = {};
  options.count = 0;
  EXPECT_THAT([&] { drawTasks(options); },
              testing::ThrowsMessage<std::invalid_argument>("count must be at least 1, not 0"));
}

TEST(TaskDataset, AFolderThatIsNoDatasetIsNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(readingFaults(folder / "nowhere"), HasSubstr("dataset.json"));
  folder.write("dataset.json", "{\"conceptplan_dataset\": 1,");
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("is not valid JSON"));
  folder.write("dataset.json", "{\"conceptplan_dataset\": 2}");
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("expected a dataset of version 1, found 2"));
}

TEST(TaskDataset, AllFaultsOfTheManifestAreTold) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  takeChecksumOut(folder / "dataset.json");
  replaceInFile(folder / "dataset.json", "\"count\": 3", "\"count\": 0");
  replaceInFile(folder / "dataset.json", "\"test\"", "\"tset\"");
  replaceInFile(folder / "dataset.json", "\"seed\": 12", "\"sead\": 12");
  const std::string faults = readingFaults(folder.path());
  EXPECT_THAT(faults, HasSubstr("options.count: expected an integer in [1, 2147483647], found 0"));
  EXPECT_THAT(faults, HasSubstr("options.split: has no value \"tset\""));
  EXPECT_THAT(faults, HasSubstr("options.seed: is missing"));
  EXPECT_THAT(faults, HasSubstr("options.sead: is unknown"));
}

TEST(TaskDataset, AManifestThatWasChangedIsRefusedAndOneWithoutAChecksumRead) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  takeChecksumOut(folder / "dataset.json");
  EXPECT_EQ(TaskDataset(folder.path()).options(), smallOptions());
  writeDataset(folder.path(), smallOptions());
  replaceInFile(folder / "dataset.json", "\"seed\": 12", "\"seed\": 13");
  EXPECT_THAT(readingFaults(folder.path()),
              HasSubstr("dataset.json: is damaged: expected checksum "));
}

TEST(TaskDataset, DamagedTasksAreRefused) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  replaceInFile(folder / "tasks.jsonl", "\"rotation\":", "\"rotatiom\":");
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("tasks.jsonl: is damaged"));
}

TEST(TaskDataset, TruncatedTasksAreRefused) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  const std::string bytes = readFile(folder / "tasks.jsonl");
  writeFileAtomically(folder / "tasks.jsonl", bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(readingFaults(folder.path()),
              HasSubstr("expected " + std::to_string(bytes.size()) + " bytes, found"));
}

TEST(TaskDataset, DamagedChecksumsAreRefused) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  replaceInFile(folder / "checksums.txt", "tasks.jsonl", "tasks.jsonk");
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("checksums.txt: is damaged"));
  std::filesystem::remove(folder / "checksums.txt");
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("checksums.txt"));
}

TEST(TaskDatasetWriter, AnInterruptedSetIsRefusedUntilItIsContinued) {
  const TemporaryFolder folder;
  TaskDatasetOptions options = smallOptions();
  options.frames = Frames::kAll;
  const TaskDatasetWriter first(folder.path(), options);
  const auto pending = first.pendingFrames();
  EXPECT_EQ(pending.size(), first.numFrames());
  first.write(pending[1], smallImage(1));
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("the generation was interrupted"));
  EXPECT_NE(faultsOf([&] { first.finish(); }), "");

  const TaskDatasetWriter second(folder.path(), options);
  EXPECT_EQ(second.pendingFrames().size(), pending.size() - 1);
  for (const auto& frame : second.pendingFrames()) second.write(frame, smallImage(1));
  second.finish();
  EXPECT_EQ(readingFaults(folder.path()), "");
}

TEST(TaskDatasetWriter, TheTasksOfAllCombinationsStayTheSame) {
  for (const auto& [split, checksum] :
       {std::pair{Split::kTrain, 0x5a881788u}, std::pair{Split::kValidation, 0xdca1eeabu},
        std::pair{Split::kTest, 0xf40ce298u}}) {
    const TemporaryFolder folder;
    TaskDatasetOptions options = smallOptions();
    options.levels = {1, 2, 3, 4};
    options.count = 50;
    options.split = split;
    options.seed = 31;
    writeDataset(folder.path(), options);
    EXPECT_EQ(crc32OfFile(folder / "tasks.jsonl"), checksum) << name(split);
  }
}

TEST(TaskDatasetWriter, AFrameWithoutItsMaskIsPending) {
  const TemporaryFolder folder;
  TaskDatasetOptions options = smallOptions();
  options.frames = Frames::kEnds;
  writeDataset(folder.path(), options);
  std::filesystem::remove(folder / "images" / "level4-000001" / "00.mask.png");
  const auto pending = TaskDatasetWriter(folder.path(), options).pendingFrames();
  ASSERT_EQ(pending.size(), 1u);
  EXPECT_EQ(pending[0].task, 1u);
  EXPECT_EQ(pending[0].step, 0);
}

TEST(TaskDatasetWriter, AnotherDatasetIsNotOverwritten) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  TaskDatasetOptions other = smallOptions();
  other.seed = 13;
  EXPECT_THAT(faultsOf([&] { TaskDatasetWriter(folder.path(), other); }),
              HasSubstr("holds another dataset"));
  EXPECT_EQ(readingFaults(folder.path()), "");
}

TEST(DatasetState, IsThatOfTheDatasetWithTheseOptions) {
  const TemporaryFolder folder;
  const TaskDatasetOptions options = smallOptions();
  EXPECT_EQ(datasetState(folder / "none", options), DatasetState::kMissing);
  EXPECT_EQ(datasetState(folder.path(), options), DatasetState::kMissing);
  const TaskDatasetWriter writer(folder.path(), options);
  EXPECT_EQ(datasetState(folder.path(), options), DatasetState::kInterrupted);
  writer.finish();
  EXPECT_EQ(datasetState(folder.path(), options), DatasetState::kComplete);
}

TEST(DatasetState, NamesEveryOptionThatDiffers) {
  const TemporaryFolder folder;
  const TaskDatasetWriter interrupted(folder.path(), smallOptions());
  TaskDatasetOptions other = smallOptions();
  other.seed = 13;
  other.combination = Combination::kUnseenTask;
  const std::string faults = faultsOf([&] { datasetState(folder.path(), other); });
  EXPECT_THAT(faults, HasSubstr(folder.path().string() +
                                ": holds another dataset; remove it or choose another folder"));
  EXPECT_THAT(faults, HasSubstr("dataset.json: options.seed: expected 13, found 12"));
  EXPECT_THAT(faults, HasSubstr("options.combination: expected \"unseen-task\", found \"all\""));
  EXPECT_THAT(faults, testing::Not(HasSubstr("options.count")));
  EXPECT_THAT(faultsOf([&] { datasetState(folder.path(), ConceptDatasetOptions{}); }),
              HasSubstr("kind: expected \"concepts\", found \"tasks\""));
}

TEST(TaskDatasetWriter, OtherFilesAreNotMixedWithADataset) {
  const TemporaryFolder folder;
  folder.write("notes.txt", "mine");
  EXPECT_THAT(faultsOf([&] { TaskDatasetWriter(folder.path(), smallOptions()); }),
              HasSubstr("is neither empty nor a dataset"));
}

}  // namespace
}  // namespace conceptplan
