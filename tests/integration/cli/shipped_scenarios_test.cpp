#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "domain/files/temporary_folder.hpp"
#include "integration/cli/command_runner.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;

TEST(ShippedScenarios, AreValid) {
  const CommandResult result = runCommand({"validate", CONCEPTPLAN_SCENARIOS});
  EXPECT_EQ(result.exit_code, 0) << result.error;
}

TEST(ShippedScenarios, TheShippedModelSolvesAllThatHaveASolution) {
  const CommandResult result = runCommand({"solve", CONCEPTPLAN_SCENARIOS, "--json"});
  EXPECT_EQ(result.exit_code, 1) << result.error;  // one has none
  std::map<std::string, int> kinds;
  const json answer = json::parse(result.out);
  for (const json& solved : answer["results"]) {
    const std::string name =
        std::filesystem::path(solved["scenario"].get<std::string>()).filename();
    ++kinds[name.substr(0, name.find('-'))];
    if (name.starts_with("infeasible")) {
      EXPECT_EQ(solved["status"], "infeasible");
    } else {
      EXPECT_EQ(solved["status"], "solved") << name;
      EXPECT_EQ(solved["evaluation"]["top1"], true) << name << ": " << solved["evaluation"];
    }
    if (solved["refinement"].is_null()) continue;
    ++kinds["refined"];
    EXPECT_EQ(solved["refinement"]["fell_back"], false) << name << ": " << solved["refinement"];
    EXPECT_GE(solved["refinement"]["clearance_m"], 0.01) << name;
  }
  EXPECT_GE(kinds["refined"], 3);
  for (const char* kind : {"level1", "level2", "level3", "level4"}) EXPECT_GE(kinds[kind], 3);
  EXPECT_GE(kinds["infeasible"], 1);
}

TEST(ShippedScenarios, TheShippedModelSolvesThoseWithTwoTargets) {
  const CommandResult result =
      runCommand({"solve", CONCEPTPLAN_SCENARIOS "/two-targets", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer["results"].size(), 2u);
  for (const json& solved : answer["results"]) {
    EXPECT_EQ(solved["evaluation"]["top1"], true) << solved;
    EXPECT_EQ(solved["evaluation"]["efficiency"], 1.0) << solved;
    const json& best = solved["plans"][0];
    EXPECT_EQ(best["objects"].size(), best["actions"].size());
  }
}

TEST(ShippedModel, SolvesTwoTargetsFromItsSymbols) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const CommandResult made = runCommand({"generate", "scenarios", "--level", "4", "--targets", "2",
                                         "--count", "5", "--symbols-only", "--out", out});
  ASSERT_EQ(made.exit_code, 0) << made.error;
  const CommandResult result =
      runCommand({"solve", out, "--planners", "astar,bfs,greedy", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer["results"].size(), 15u);
  for (const json& solved : answer["results"]) {
    EXPECT_EQ(solved["evaluation"]["top1"], true) << solved;
    if (solved["planner"] != "greedy") {
      EXPECT_EQ(solved["evaluation"]["efficiency"], 1.0) << solved;
    }
  }
  EXPECT_EQ(runCommand({"solve", out, "--planners", "belief"}).exit_code, 2);
}

TEST(ShippedModel, SolvesFromItsSymbols) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const CommandResult made = runCommand(
      {"generate", "scenarios", "--level", "4", "--count", "3", "--symbols-only", "--out", out});
  ASSERT_EQ(made.exit_code, 0) << made.error;
  const CommandResult result = runCommand({"solve", out, "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const json answer = json::parse(result.out);
  for (const json& solved : answer["results"]) {
    EXPECT_EQ(solved["evaluation"]["top1"], true) << solved;
  }
}

}  // namespace
}  // namespace conceptplan::cli
