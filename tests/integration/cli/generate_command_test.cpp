#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "domain/files/temporary_folder.hpp"
#include "integration/cli/command_runner.hpp"
#include "scenario_generation.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(GenerateTasks, TheSeedDecidesAndInspectCounts) {
  const TemporaryFolder folder;
  const std::string out = (folder / "tasks").string();
  const CommandResult made =
      runCommand({"generate", "tasks", "--level", "1,3", "--count", "20", "--split", "test",
                  "--no-images", "--seed", "7", "--out", out, "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.error;
  EXPECT_EQ(json::parse(made.out)["tasks"], 40);
  EXPECT_EQ(TaskDataset(out).options().seed, 7u);

  const CommandResult inspected = runCommand({"inspect", "dataset", out, "--json"});
  EXPECT_EQ(inspected.exit_code, 0) << inspected.error;
  const json summary = json::parse(inspected.out);
  EXPECT_EQ(summary["tasks"], 40);
  EXPECT_EQ(summary["images"], 0);
  EXPECT_EQ(summary["splits"]["test"], 40);
  EXPECT_TRUE(summary["checksums_ok"]);
  EXPECT_GT(summary["length"]["mean"], 1);
  EXPECT_EQ(summary["length"]["histogram"].size(), summary["length"]["max"].get<int>() + 1);
  EXPECT_TRUE(summary["objects"].contains("Dyer"));
}

TEST(GenerateTasks, OptionsThatDoNotGoTogetherAreAWrongCall) {
  const TemporaryFolder folder;
  const CommandResult result =
      runCommand({"generate", "tasks", "--level", "3", "--combination", "unseen-task", "--split",
                  "test", "--no-images", "--out", (folder / "tasks").string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("generate tasks: "));
}

TEST(GenerateTasks, InterruptedItKeepsItsPicturesAndGoesOn) {
  const TemporaryFolder folder;
  const std::string out = (folder / "tasks").string();
  const std::vector<std::string> small{"generate", "tasks", "--count", "40",
                                       "--frames", "ends",  "--out",   out};
  const CommandResult interrupted = runInterrupted(small, [&] {
    return std::filesystem::exists(folder / "tasks/images/level1-000001/00.mask.png");
  });
  ASSERT_EQ(interrupted.exit_code, 130) << interrupted.error;
  EXPECT_THAT(interrupted.error, HasSubstr("interrupted; what was finished is kept"));
  EXPECT_EQ(runCommand({"inspect", "dataset", out}).exit_code, 2);
  const auto first = folder / "tasks/images/level1-000000/00.rgb.png";
  const auto written = std::filesystem::last_write_time(first);
  EXPECT_EQ(runCommand(small).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(first), written);
  EXPECT_EQ(runCommand({"inspect", "dataset", out}).exit_code, 0);
}

TEST(InspectDataset, DamageIsNamedAndExits2) {
  const TemporaryFolder folder;
  const std::string out = (folder / "tasks").string();
  ASSERT_EQ(
      runCommand({"generate", "tasks", "--count", "5", "--no-images", "--out", out}).exit_code, 0);
  std::string text = readFile(folder / "tasks/tasks.jsonl");
  text[text.size() / 2] ^= 1;
  folder.write("tasks/tasks.jsonl", text);
  const CommandResult result = runCommand({"inspect", "dataset", out, "--json"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_FALSE(json::parse(result.out)["checksums_ok"]);
  EXPECT_THAT(result.error, HasSubstr("tasks.jsonl"));
}

TEST(InspectDataset, OtherFoldersAreRefused) {
  const TemporaryFolder folder;
  const CommandResult result = runCommand({"inspect", "dataset", folder.path().string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr(folder.path().string()));
}

TEST(GenerateScenarios, SymbolsNeedTheirModel) {
  const TemporaryFolder folder;
  const CommandResult result = runCommand({"generate", "scenarios", "--symbols-only", "--model",
                                           "absent-model", "--out", folder.path().string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("absent-model"));
}

TEST(GenerateScenarios, PicturesAreTheSameAtAnyNumberOfJobs) {
  const TemporaryFolder folder;
  const std::string one = (folder / "one").string();
  const std::string two = (folder / "two").string();
  for (const auto& [out, jobs] : {std::pair{one, "1"}, std::pair{two, "2"}}) {
    ASSERT_EQ(runCommand({"generate", "scenarios", "--level", "2", "--count", "2", "--jobs", jobs,
                          "--out", out})
                  .exit_code,
              0);
  }
  for (const char* file :
       {"initial.rgb.png", "goal.depth.png", "goal.mask.png", "scenario.yaml", "reference.yaml"}) {
    EXPECT_EQ(readFile(folder / "one/level2-0002" / file),
              readFile(folder / "two/level2-0002" / file))
        << file;
  }
  const CommandResult inspected =
      runCommand({"inspect", "scenario", one + "/level2-0001", "--json"});
  EXPECT_EQ(inspected.exit_code, 0);
  EXPECT_EQ(json::parse(inspected.out)["initial"]["width"], 384);
}

TEST(ScenarioGeneration, InfeasibleTargetsCannotMove) {
  ScenarioSetOptions options;
  options.infeasible = true;
  for (int i = 0; i < 20; ++i) {
    const Task task = drawReference(options, i).task;
    EXPECT_TRUE(task.reference.empty());
    EXPECT_NE(task.goal.cell, task.initial.objects[task.initial.target].cell);
    for (const Action action :
         {Action::kMoveFront, Action::kMoveBack, Action::kMoveLeft, Action::kMoveRight}) {
      EXPECT_FALSE(applyAction(task.initial, action).succeeded());
    }
    for (const ObjectState& object : task.initial.objects) EXPECT_NE(object.cell, task.goal.cell);
  }
  EXPECT_EQ(scenarioName(options, 0), "infeasible-0001");
}

TEST(ScenarioGeneration, SymbolsFollowTheNamesOfTheModel) {
  SymbolGrounding grounding = standardGrounding();
  std::swap(grounding.names[index(Concept::kColor)][0], grounding.names[index(Concept::kColor)][5]);
  const ObjectState red{ObjectType::kCup, {1, 2}, 3, 0, 2};
  EXPECT_EQ(std::get<SymbolId>(symbolsOf(red, grounding)[index(Concept::kColor)]), SymbolId{5});
  grounding.names[index(Concept::kType)].clear();
  EXPECT_THAT(faultsOf([&] { symbolsOf(red, grounding); }),
              HasSubstr("TYPE: the model has no symbol named \"Cup\""));
}

TEST(ScenarioGeneration, TwoTargetsHaveAGoalAndAPlan) {
  ScenarioSetOptions options;
  options.tasks.level = 3;
  options.targets = 2;
  for (int i = 0; i < 10; ++i) {
    const Task task = drawReference(options, i).task;
    EXPECT_EQ(task.further.size(), 1u);
    EXPECT_TRUE(judge(task, task.reference, task.moved).succeeded());
  }
  EXPECT_EQ(scenarioName(options, 0), "level3x2-0001");
}

TEST(GenerateScenarios, TwoTargetsAreRefusedWhereThereIsNoObstacle) {
  const TemporaryFolder folder;
  const CommandResult result =
      runCommand({"generate", "scenarios", "--targets", "2", "--out", folder.path().string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("--targets: 2 need --level 2..4"));
}

}  // namespace
}  // namespace conceptplan::cli
