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
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "domain/dataset/reseal.hpp"
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

RgbdImage plainImage(std::uint8_t value, int width = kFrameWidth, int height = kFrameHeight) {
  const auto pixels = static_cast<std::size_t>(width * height);
  return {width, height, std::vector<std::uint8_t>(pixels * 3, value),
          std::vector<float>(pixels, 2.5F), std::vector<std::uint8_t>(pixels, 1)};
}

void writeDataset(const std::filesystem::path& folder, const TaskDatasetOptions& options) {
  const TaskDatasetWriter writer(folder, options);
  for (const auto& frame : writer.pendingFrames())
    writer.write(frame, plainImage(static_cast<std::uint8_t>(frame.step)));
  writer.finish();
}

void replaceInFile(const std::filesystem::path& path, const std::string& from,
                   const std::string& to) {
  std::string bytes = readFile(path);
  const std::size_t position = bytes.find(from);
  ASSERT_NE(position, std::string::npos) << path;
  writeFileAtomically(path, bytes.replace(position, from.size(), to));
}

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
  EXPECT_EQ(goal.rgb, plainImage(static_cast<std::uint8_t>(last)).rgb);
  EXPECT_EQ(goal.mask, plainImage(0).mask);
  EXPECT_NEAR(goal.depth_m[1], 2.5, 1e-6);
}

TEST(TaskDataset, PicturesThatASetWasMadeWithoutAreNamedOnce) {
  const TemporaryFolder folder;
  TaskDatasetOptions options = smallOptions();
  writeDataset(folder / "none", options);
  options.frames = Frames::kEnds;
  writeDataset(folder / "ends", options);
  const Task task = TaskDataset(folder / "none").tasks()[0];
  EXPECT_EQ(faultsOf([&] { TaskDataset(folder / "none").frame(task, 0); }),
            (folder / "none").string() +
                ": frames: the set has no picture of step 0 of level4-000000: it was made with "
                "--frames none; generate tasks --frames all makes one with the pictures of all "
                "steps, --frames ends one with those of start and goal\n");
  EXPECT_THAT(faultsOf([&] { TaskDataset(folder / "ends").frame(task, 1); }),
              HasSubstr("no picture of step 1 of level4-000000: it was made with --frames ends"));
}

TEST(TaskDataset, PicturesOfAnotherSizeAreRefused) {
  const TemporaryFolder folder;
  TaskDatasetOptions options = smallOptions();
  options.frames = Frames::kEnds;
  writeDataset(folder.path(), options);
  writeRgbdImage(folder / "images" / "level4-000001" / "00", plainImage(0, 90, 90));
  resealDataset(folder.path());
  const TaskDataset dataset(folder.path());
  EXPECT_NO_THROW(dataset.frame(dataset.tasks()[0], 0));
  EXPECT_EQ(faultsOf([&] { dataset.frame(dataset.tasks()[1], 0); }),
            (folder / "images" / "level4-000001" / "00.rgb.png").string() +
                ": rgb: expected 384 x 256 pixels, found 90 x 90\n");
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
  replaceInFile(folder / "dataset.json", "\"count\": 3", "\"count\": 0");
  replaceInFile(folder / "dataset.json", "\"test\"", "\"tset\"");
  replaceInFile(folder / "dataset.json", "\"seed\": 12", "\"sead\": 12");
  resealJson(folder / "dataset.json");
  const std::string faults = readingFaults(folder.path());
  EXPECT_THAT(faults, HasSubstr("options.count: expected an integer in [1, 2147483647], found 0"));
  EXPECT_THAT(faults, HasSubstr("options.split: has no value \"tset\""));
  EXPECT_THAT(faults, HasSubstr("options.seed: is missing"));
  EXPECT_THAT(faults, HasSubstr("options.sead: is unknown"));
}

TEST(TaskDataset, LevelsOfTheManifestAreAListOfDifferentOnes) {
  for (const auto& [levels, fault] :
       {std::pair{"3", "options.levels: expected a list of levels"},
        std::pair{"[]", "options.levels: expected a list of levels"},
        std::pair{"[1, 1]", "options.levels: level 1 is named twice"},
        std::pair{"[5, 1]", "options.levels: expected levels in [1, 4], found 5"}}) {
    const TemporaryFolder folder;
    writeDataset(folder.path(), smallOptions());
    replaceInFile(folder / "dataset.json", "[\n      4,\n      1\n    ]", levels);
    resealJson(folder / "dataset.json");
    EXPECT_THAT(readingFaults(folder.path()), HasSubstr(fault)) << levels;
  }
}

TEST(TaskDataset, AManifestThatWasChangedIsRefusedWithAndWithoutItsChecksum) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  replaceInFile(folder / "dataset.json", "\"seed\": 12", "\"seed\": 13");
  EXPECT_THAT(readingFaults(folder.path()),
              HasSubstr("dataset.json: is damaged: expected checksum "));
  takeChecksumOut(folder / "dataset.json");
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("dataset.json: checksum: is missing"));
}

/// What is wrong with a set of one task of level 3 after a change of its only line.
std::string faultsAfter(const std::string& from, const std::string& to) {
  const TemporaryFolder folder;
  TaskDatasetOptions options = smallOptions();
  options.levels = {3};
  options.count = 1;
  writeDataset(folder.path(), options);
  replaceInFile(folder / "tasks.jsonl", from, to);
  resealDataset(folder.path());
  return readingFaults(folder.path());
}

TEST(TaskDataset, ASetOfOtherTasksThanItsOptionsSayIsRefused) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), smallOptions());
  const std::string lines = readFile(folder / "tasks.jsonl");
  const auto faults_with = [&](const std::string& text) {
    writeFileAtomically(folder / "tasks.jsonl", text);
    resealDataset(folder.path());
    return readingFaults(folder.path());
  };
  EXPECT_EQ(faults_with(lines), "");
  EXPECT_THAT(faults_with(""), HasSubstr("tasks.jsonl: expected 6 tasks, found 0"));
  const std::string first = lines.substr(0, lines.find('\n') + 1);
  EXPECT_THAT(faults_with(lines + first), HasSubstr("tasks.jsonl: expected 6 tasks, found 7"));
  EXPECT_THAT(faults_with(lines.substr(first.size()) + first),
              testing::AllOf(HasSubstr("tasks.jsonl:3: level: expected 4, found 1"),
                             HasSubstr("tasks.jsonl:6: level: expected 1, found 4")));
  EXPECT_THAT(faultsAfter("\"level\":3", "\"level\":2"),
              HasSubstr("tasks.jsonl:1: level: expected 3, found 2"));
}

TEST(TaskDataset, OtherWorkbenchesThanTheStandardOneAreRefused) {
  for (const auto& [from, to] :
       {std::pair{"\"cell_m\":0.2", "\"cell_m\":1e-300"}, std::pair{"\"rows\":5", "\"rows\":6"},
        std::pair{"\"columns\":3", "\"columns\":\"3\""}})
    EXPECT_THAT(faultsAfter(from, to),
                HasSubstr("tasks.jsonl:1: workbench: expected {\"cell_m\":0.2,"
                          "\"columns\":3,\"rows\":5}, found {"));
}

TEST(TaskDataset, MoreObjectsThanInstanceIdsAreRefusedAndSoAreTwoInACell) {
  const std::string egg = R"({"type":"Egg","x":0,"y":0,"rotation":0,"color":"red","size":0},)";
  std::string eggs;
  for (int i = 0; i < 255; ++i) eggs += egg;
  EXPECT_THAT(faultsAfter("\"objects\":[", "\"objects\":[" + eggs),
              HasSubstr("tasks.jsonl:1: objects: expected a list of 1 to 255 objects"));
  EXPECT_THAT(faultsAfter("\"objects\":[", "\"objects\":[" + egg + egg),
              HasSubstr("tasks.jsonl:1: objects[1]: is in the cell of another object"));
}

TEST(TaskDataset, ReferencesThatTheSimulatorDoesNotFollowToTheGoalAreRefused) {
  EXPECT_THAT(
      faultsAfter("\"reference\":[", "\"reference\":[\"move_left\",\"move_left\",\"move_left\","),
      testing::ContainsRegex("tasks.jsonl:1: reference: action [123], move_left, is illegal: "
                             "(off_workbench|collision)"));
  EXPECT_THAT(faultsAfter("\"reference\":[", "\"reference\":[\"rotate_left\","),
              HasSubstr("tasks.jsonl:1: reference: does not end at the goal"));
  EXPECT_THAT(faultsAfter("\"reference\":[", "\"reference\":[],\"else\":["),
              HasSubstr("tasks.jsonl:1: reference: expected a list of actions"));
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
  first.write(pending[1], plainImage(1));
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("the generation was interrupted"));
  EXPECT_NE(faultsOf([&] { first.finish(); }), "");

  const TaskDatasetWriter second(folder.path(), options);
  EXPECT_EQ(second.pendingFrames().size(), pending.size() - 1);
  for (const auto& frame : second.pendingFrames()) second.write(frame, plainImage(1));
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
