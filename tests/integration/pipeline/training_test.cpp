#include "conceptplan/pipeline/training.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset_writer.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "integration/pipeline/temporary_folder.hpp"

namespace conceptplan {
namespace {

const std::vector<TrainingStage> kAll{TrainingStage::kLearnConcepts, TrainingStage::kMakeSymbols,
                                      TrainingStage::kCountTransitions, TrainingStage::kTrainVict};

TrainingOptions smokeOptions(const std::filesystem::path& folder, const std::string& model) {
  TrainingOptions options;
  options.data = folder / "data";
  options.model = folder / model;
  options.profile = "smoke";
  options.jobs = 1;
  return options;
}

/// Tests of a model that was trained once, without interruption.
class TrainedModel : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    root_ = std::filesystem::path(testing::TempDir()) /
            ("conceptplan-trained-" + std::to_string(::getpid()));
    std::filesystem::create_directories(root_);
    TrainingControl control;
    control.progress = [](const TrainingProgress& progress) { reports_.push_back(progress); };
    control.warning = [](const std::string& text) { warnings_.push_back(text); };
    done_ = train(kAll, smokeOptions(root_, "whole"), control);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(root_); }

  void SetUp() override { ASSERT_TRUE(done_); }

  static inline std::filesystem::path root_;
  static inline bool done_ = false;
  static inline std::vector<TrainingProgress> reports_;
  static inline std::vector<std::string> warnings_;
};

TEST_F(TrainedModel, LearnedFromNoPlanThatIsHeldOut) {
  const TaskDataset tasks(root_ / "data" / "tasks-train");
  std::set<int> levels;
  for (const Task& task : tasks.tasks()) {
    levels.insert(task.level);
    EXPECT_FALSE(isHeldOut(task.reference)) << task.id;
  }
  EXPECT_THAT(levels, testing::ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(tasks.options().combination, Combination::kUnseenTask);
}

TEST_F(TrainedModel, InterruptedAndResumedEndsWithTheSameModel) {
  const TrainingOptions whole = smokeOptions(root_, "whole");
  EXPECT_GT(Model(whole.model).numParameters(), 100'000U);

  // Cancelled at each stage's first report, then resumed, until nothing is left to do.
  TrainingOptions parts = smokeOptions(root_, "parts");
  parts.resume = true;
  std::vector<std::string> seen;
  bool done = false;
  for (int attempt = 0; attempt < 20 && !done; ++attempt) {
    std::atomic<bool> cancel{false};
    TrainingControl control;
    control.cancel = &cancel;
    control.progress = [&](const TrainingProgress& progress) {
      if (progress.stage.starts_with("reading") ||
          std::find(seen.begin(), seen.end(), progress.stage) != seen.end())
        return;
      seen.push_back(progress.stage);
      cancel = true;
    };
    done = train(kAll, parts, control);
  }
  EXPECT_TRUE(done);
  EXPECT_THAT(seen, testing::IsSupersetOf({"concepts", "transitions", "vict"}));
  for (const char* file : {kConceptsFile, kSymbolsFile, kTransitionsFile, kVictFile})
    EXPECT_EQ(readFile(whole.model / file), readFile(parts.model / file)) << file;
  EXPECT_FALSE(std::filesystem::exists(parts.model / "concepts.checkpoint"));
}

TEST_F(TrainedModel, ToldWhichStageOfAllAndWhatWasLeft) {
  ASSERT_FALSE(reports_.empty());
  std::vector<TrainingProgress> steps;
  double left = 1e9;
  int number = 1;
  for (const TrainingProgress& report : reports_) {
    EXPECT_EQ(report.num_stages, 4);
    EXPECT_GE(report.stage_number, number);
    EXPECT_LE(report.left, left) << report.stage;
    number = report.stage_number;
    left = report.left;
    if (report.stage == "concepts") steps.push_back(report);
  }
  EXPECT_EQ(reports_.front().worked, 0);
  EXPECT_EQ(reports_.front().stage, "data: concepts-train");
  EXPECT_EQ(number, 4);
  EXPECT_NEAR(left, 0, 1e-9);
  // What was done before the first report of a work may be of an earlier run, and does not count.
  EXPECT_LE(reports_.back().worked, reports_.front().left);
  EXPECT_GT(reports_.back().worked, 0.75 * reports_.front().left);

  // Three steps that teach tokens and one that teaches the drawer, which is a shorter one.
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[0].stage_number, 1);
  EXPECT_NEAR(steps[0].share, 2.5 / 8.5, 1e-9);
  EXPECT_EQ(steps[3].share, 1);
  EXPECT_NEAR((steps[0].left - steps[1].left) / (steps[2].left - steps[3].left), 2.5, 1e-9);
  EXPECT_GT(steps[3].left, 25);
  EXPECT_LT(steps[3].left, 35) << "concepts take most of the time";
}

TEST_F(TrainedModel, RefusesDataOfOtherOptions) {
  TrainingOptions other = smokeOptions(root_, "other");
  other.seed = 2;
  EXPECT_THAT([&] { train(kAll, other, {}); },
              testing::ThrowsMessage<InputError>(testing::AllOf(
                  testing::HasSubstr("concepts-train: holds another dataset; remove it or choose"),
                  testing::HasSubstr("options.seed: expected 2, found 1"))));
  other.seed = 1;
  other.profile = "cpu";
  EXPECT_THAT([&] { train(kAll, other, {}); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("options.samples: expected 6, found 1")));

  const TemporaryFolder folder;
  TaskDatasetOptions tasks = TaskDataset(root_ / "data" / "tasks-train").options();
  tasks.combination = Combination::kAll;
  tasks.frames = Frames::kNone;
  TaskDatasetWriter(folder.path() / "data" / "tasks-train", tasks).finish();
  TrainingOptions transitions = smokeOptions(folder.path(), "");
  transitions.model = root_ / "whole";
  transitions.anew = true;
  EXPECT_THAT(
      [&] { train({TrainingStage::kCountTransitions}, transitions, {}); },
      testing::ThrowsMessage<InputError>(testing::AllOf(
          testing::HasSubstr("options.combination: expected \"unseen-task\", found \"all\""),
          testing::HasSubstr("options.frames: expected \"all\", found \"none\""))));
  EXPECT_TRUE(readModelManifest(root_ / "whole").has(TrainingStage::kTrainVict));
}

TEST_F(TrainedModel, WarnedOfSymbolsThatMayBeMergedOrSplitValues) {
  const ModelManifest manifest = readModelManifest(root_ / "whole");
  std::vector<testing::Matcher<std::string>> expected;
  for (const Concept which : kConcepts)
    if (manifest.measures.at("train/suspicious_clusters/" + std::string(name(which))) > 0)
      expected.push_back(testing::MatchesRegex("symbols of " + std::string(name(which)) +
                                               " may be merged or split values: cluster.*"));
  EXPECT_FALSE(expected.empty());  // it has learned next to nothing
  EXPECT_THAT(warnings_, testing::ElementsAreArray(expected));
}

TEST_F(TrainedModel, RefusesModelsOfAnotherSeedOrProfile) {
  TrainingOptions other = smokeOptions(root_, "whole");
  other.data = root_ / "other-data";
  other.resume = true;
  other.seed = 2;
  EXPECT_THAT([&] { train(kAll, other, {}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr(
                  "manifest.json: seed: expected 2, found 1; go on with --seed 1")));
  other.seed = 1;
  other.profile = "cpu";
  EXPECT_THAT(
      [&] { train(kAll, other, {}); },
      testing::ThrowsMessage<InputError>(testing::HasSubstr(
          "manifest.json: profile: expected cpu, found smoke; go on with --profile smoke")));
}

TEST_F(TrainedModel, RefusesToGoOnWithAnotherNumberOfThreads) {
  const TemporaryFolder folder;
  TrainingOptions options = smokeOptions(root_, "whole");
  options.model = folder.path();
  options.resume = true;
  std::atomic<bool> cancel{false};
  TrainingControl control;
  control.cancel = &cancel;
  control.progress = [&](const TrainingProgress& progress) {
    if (progress.stage == "concepts") cancel = true;
  };
  EXPECT_FALSE(train(kAll, options, control));
  options.jobs = 2;
  EXPECT_THAT([&] { train(kAll, options, {}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr(
                  "concepts.checkpoint: threads: this run has 2, the checkpoint is of 1; go on "
                  "with --jobs 1")));
  options.jobs = 1;
  options.start_from = root_ / "whole";
  EXPECT_THAT([&] { train(kAll, options, {}); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("concepts.checkpoint: start_from: this run has ")));
}

TEST_F(TrainedModel, RefusesDataThatAreADatasetThemselves) {
  TrainingOptions options = smokeOptions(root_, "other");
  options.data /= "tasks-train";
  EXPECT_THAT([&] { train(kAll, options, {}); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("tasks-train: is a dataset; expected a folder of datasets")));
  EXPECT_FALSE(std::filesystem::exists(options.data / "concepts-train"));
}

TEST_F(TrainedModel, RefusesToUndoWhatIsFinishedOrBegunUnlessAsked) {
  TrainingOptions options = smokeOptions(root_, "whole");
  const auto refused = [&](const std::vector<TrainingStage>& stages) {
    EXPECT_THAT([&] { train(stages, options, {}); },
                testing::ThrowsMessage<InputError>(
                    testing::HasSubstr("finished or begun; go on with --resume, or begin again "
                                       "with --anew")));
  };
  const std::string manifest = readFile(options.model / "manifest.json");
  refused(kAll);
  refused({TrainingStage::kLearnConcepts});
  refused({TrainingStage::kTrainVict});
  EXPECT_EQ(readFile(options.model / "manifest.json"), manifest);

  const TemporaryFolder folder;
  options.model = folder.path();
  const auto checkpoint = folder.path() / "concepts.checkpoint";
  writeFileAtomically(checkpoint, "of hours of work");
  refused(kAll);
  EXPECT_EQ(readFile(checkpoint), "of hours of work");

  options.anew = options.resume = true;
  EXPECT_THROW(train(kAll, options, {}), std::invalid_argument);
}

TEST_F(TrainedModel, NamesTheStageThatMakesALostFileAgain) {
  const TemporaryFolder folder;
  TrainingOptions options = smokeOptions(root_, "whole");
  options.model = folder.path() / "model";
  std::filesystem::copy(root_ / "whole", options.model);
  std::filesystem::remove(options.model / kVictFile);
  options.resume = true;
  EXPECT_THAT([&] { train(kAll, options, {}); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("; bring it back, or train stage vict again, with --anew")));
  options.resume = false;
  options.anew = true;
  EXPECT_TRUE(train({TrainingStage::kTrainVict}, options, {}));
  EXPECT_EQ(readFile(options.model / kVictFile), readFile(root_ / "whole" / kVictFile));
}

TEST_F(TrainedModel, LearnsWithThePapersNetworksToo) {
  TrainingOptions options = smokeOptions(root_, "paper");
  options.profile = "smoke-paper";
  EXPECT_TRUE(train(kAll, options, {}));
  const Model model(options.model);
  EXPECT_EQ(model.manifest().encoder, EncoderKind::kFullFrame);
  const TaskDataset tasks(root_ / "data" / "tasks-train");
  EXPECT_FALSE(model.perceive(tasks.frame(tasks.tasks().front(), 0)).tokens.empty());
}

TEST_F(TrainedModel, TrainedAnewItIsNotFinishedUntilItIs) {
  const TemporaryFolder folder;
  TrainingOptions options = smokeOptions(root_, "whole");
  options.model = folder.path() / "model";
  options.anew = true;
  std::filesystem::copy(root_ / "whole", options.model);
  for (const TrainingStage stage :
       {TrainingStage::kTrainVict, TrainingStage::kMakeSymbols, TrainingStage::kLearnConcepts}) {
    const auto checkpoint = options.model / (std::string(name(stage)) + ".checkpoint");
    writeFileAtomically(checkpoint, "of an earlier training");
    const std::vector<TrainingStage> stages(kAll.begin() + static_cast<int>(stage), kAll.end());
    const std::atomic<bool> cancel{true};
    TrainingControl control;
    control.cancel = &cancel;
    EXPECT_FALSE(train(stages, options, control));
    if (stage == TrainingStage::kLearnConcepts) {
      EXPECT_FALSE(std::filesystem::exists(options.model / "manifest.json"));
    } else {
      const ModelManifest manifest = readModelManifest(options.model);
      EXPECT_EQ(manifest.stages, std::vector(kAll.begin(), kAll.begin() + static_cast<int>(stage)));
    }
    if (std::filesystem::exists(checkpoint)) {
      EXPECT_NE(readFile(checkpoint), "of an earlier training");
    }
  }
  options.anew = false;
  options.resume = true;
  EXPECT_TRUE(train(kAll, options, {}));
  for (const char* file : {kConceptsFile, kSymbolsFile, kTransitionsFile, kVictFile})
    EXPECT_EQ(readFile(root_ / "whole" / file), readFile(options.model / file)) << file;
}

TEST_F(TrainedModel, AWrongCallLeavesItAsItWas) {
  TrainingOptions options = smokeOptions(root_, "whole");
  options.anew = true;
  const std::string manifest = readFile(options.model / "manifest.json");
  options.start_from = root_ / "nowhere";
  EXPECT_THROW(train(kAll, options, {}), InputError);
  options.start_from.clear();
  options.seed = 2;
  EXPECT_THROW(train(kAll, options, {}), InputError);
  EXPECT_THROW(train({TrainingStage::kTrainVict}, options, {}), InputError);
  EXPECT_EQ(readFile(options.model / "manifest.json"), manifest);
}

TEST(Train, RefusesUnknownProfilesAndStagesWithoutTheirPredecessors) {
  const TemporaryFolder folder;
  TrainingOptions options = smokeOptions(folder.path(), "model");
  EXPECT_THAT([&] { train({TrainingStage::kCountTransitions}, options, {}); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("stage transitions needs the stages before it")));
  options.profile = "cpus";
  EXPECT_THAT([&] { train(kAll, options, {}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("unknown profile \"cpus\"")));
}

}  // namespace
}  // namespace conceptplan
