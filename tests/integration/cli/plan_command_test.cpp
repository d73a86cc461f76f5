#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "conceptplan/domain/concept.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "integration/cli/command_runner.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string kInfeasible = CONCEPTPLAN_SCENARIOS "/infeasible-0001";

/// A folder for what `plan` writes.
class PlanCommand : public testing::Test {
 protected:
  CommandResult plan(const std::string& scenario, const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments{"plan", scenario, "--no-render", "--out", out()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runCommand(arguments);
  }
  std::string report() const { return readFile(folder_ / "out/report.html"); }

  json result() const { return json::parse(readFile(folder_ / "out/result.json")); }

  /// A copy of a shipped scenario whose file has one text replaced by another.
  std::string changed(const std::string& scenario, const std::string& from,
                      const std::string& to) const {
    const std::filesystem::path copy = folder_ / "scenario";
    std::filesystem::copy(scenario, copy, std::filesystem::copy_options::recursive);
    std::string text = readFile(copy / "scenario.yaml");
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from << " is not in\n" << text;
    writeFileAtomically(copy / "scenario.yaml", text.replace(at, from.size(), to));
    return copy.string();
  }

  std::string out() const { return (folder_ / "out").string(); }

  const TemporaryFolder folder_;
};

TEST_F(PlanCommand, TheReportTellsThePlannersLegalityThreshold) {
  ASSERT_EQ(plan(kInfeasible).exit_code, 1);
  EXPECT_THAT(report(), HasSubstr("more than 1.0&nbsp;% are needed"));
  const std::string scenario =
      changed(kInfeasible, "name: belief", "name: belief, options: {legality_threshold: 0.025}");
  ASSERT_EQ(plan(scenario).exit_code, 1);
  EXPECT_THAT(report(), HasSubstr("more than 2.5&nbsp;% are needed"));
  // Options are those of the scenario's own planner.
  ASSERT_EQ(plan(scenario, {"--planner", "astar"}).exit_code, 1);
  EXPECT_THAT(report(), HasSubstr("more than 1.0&nbsp;% are needed"));
}

TEST_F(PlanCommand, FilesOfAnEarlierRunDoNotStay) {
  const std::string refined = CONCEPTPLAN_SCENARIOS "/level3-0002";
  ASSERT_EQ(plan(refined).exit_code, 0);
  const std::filesystem::path folder = out();
  EXPECT_TRUE(std::filesystem::exists(folder / "trajectory.json"));
  for (const char* file : {"step-01.png", "step-17.png", "notes.txt"}) {
    writeFileAtomically(folder / file, "");
  }
  const std::string plain = changed(refined, "refine: {clearance_m: 0.01}\n", "");
  ASSERT_EQ(plan(plain).exit_code, 0);
  std::set<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    left.insert(entry.path().filename());
  }
  EXPECT_EQ(left, (std::set<std::string>{"notes.txt", "report.html", "result.json"}));
  EXPECT_TRUE(result()["refinement"].is_null());
}

TEST_F(PlanCommand, TheScenarioChoosesTheAlgorithmOfTheRefinement) {
  const std::string refined = CONCEPTPLAN_SCENARIOS "/level3-0002";
  ASSERT_EQ(plan(refined).exit_code, 0);
  const std::string motion = readFile(folder_ / "out/trajectory.csv");
  const std::string other =
      changed(refined, "clearance_m: 0.01", "clearance_m: 0.01, algorithm: mma");
  ASSERT_EQ(plan(other).exit_code, 0);
  EXPECT_FALSE(result()["refinement"]["fell_back"]) << result()["refinement"];
  EXPECT_NE(readFile(folder_ / "out/trajectory.csv"), motion);
}

TEST_F(PlanCommand, ObjectsHaveTheSameNameEverywhere) {
  const CommandResult result = plan(kInfeasible);
  EXPECT_THAT(result.out, HasSubstr("without Lettuce 1 there would be a way"));
  EXPECT_THAT(this->result()["reason"].get<std::string>(),
              HasSubstr("without Lettuce 1 there would be a way"));
  EXPECT_THAT(report(), HasSubstr("without Lettuce 1 there would be a way"));
  for (const std::string& text : {result.out, this->result().dump(), report()}) {
    EXPECT_THAT(text, Not(HasSubstr("object 0")));
  }
  const std::filesystem::path steps = folder_.write("sas_plan", "(move_front)\n");
  EXPECT_THAT(runCommand({"validate", "--plan", steps.string(), kInfeasible}).error,
              HasSubstr("step 1, move_front: its most probable outcome meets Lettuce 1\n"));
}

TEST_F(PlanCommand, TheTraceTellsWhyThereIsNoPlan) {
  ASSERT_EQ(plan(kInfeasible).exit_code, 1);
  const json trace = result()["trace"];
  EXPECT_EQ(trace["legality_threshold"], 0.01);
  EXPECT_EQ(trace["blocking"].dump(), R"([{"name":"Lettuce 1","object":1}])");
  EXPECT_EQ(trace["nearest"]["differs_in"].dump(), R"(["position_y"])");
  std::map<std::string, int> causes;
  for (const json& step : trace["rejections"]) {
    const std::string cause = step["cause"];
    ++causes[cause];
    EXPECT_EQ(step["state"].size(), kNumConcepts);
    EXPECT_EQ(step.contains("probability"), cause == "legality") << step;
    EXPECT_EQ(step.contains("depth_m"), cause != "legality") << step;
    if (cause == "legality") {
      EXPECT_LE(step["probability"], 0.01);
    }
    if (cause != "collision") continue;
    EXPECT_EQ(step["name"], step["object"] == 1 ? "Lettuce 1" : "Tomato 3");
    EXPECT_GT(step["depth_m"], 0);
    EXPECT_LT(step["depth_m"], 0.2);
  }
  EXPECT_EQ(causes["legality"], 12);
  EXPECT_EQ(causes["collision"], 8);
  // The target cannot leave its place, so the whole search saw no more than these.
  EXPECT_EQ(trace["expansions"]["states"], 4);
  std::map<std::string, int> counted;
  for (const json& count : trace["expansions"]["ruled_out"]) {
    counted[count["cause"].get<std::string>()] += count["steps"].get<int>();
  }
  EXPECT_EQ(counted, causes);

  const std::string page = report();
  EXPECT_THAT(page, HasSubstr("Without <strong>Lettuce 1</strong> there would be a way."));
  EXPECT_THAT(page, HasSubstr("The nearest to the goal that is in reach has row 0 in place of "
                              "<strong>row 4</strong>."));
  EXPECT_THAT(page, HasSubstr("12 by the action threshold and 8 by collision"));
}

TEST_F(PlanCommand, TheTraceTellsWhatWasRuledOutBesideAPlan) {
  ASSERT_EQ(plan(CONCEPTPLAN_SCENARIOS "/level3-0001").exit_code, 0);
  const json trace = result()["trace"];
  EXPECT_FALSE(trace["rejections"].empty());
  EXPECT_TRUE(trace["blocking"].empty());
  EXPECT_TRUE(trace["nearest"].is_null());
}

TEST_F(PlanCommand, TheTraceOfSeveralTargetsTellsWhichOneEachStepMoves) {
  ASSERT_EQ(plan(CONCEPTPLAN_SCENARIOS "/two-targets/level3x2-0001").exit_code, 0);
  const json trace = result()["trace"];
  EXPECT_EQ(trace["legality_threshold"], 0.01);
  ASSERT_FALSE(trace["rejections"].empty());
  for (const json& step : trace["rejections"]) {
    EXPECT_THAT(step["moved_name"].get<std::string>(),
                testing::EndsWith(" " + step["moved"].dump()));
  }
  EXPECT_GT(trace["expansions"]["states"], 0);
  EXPECT_FALSE(trace["expansions"]["ruled_out"].empty());
  EXPECT_THAT(report(), HasSubstr("states that the search expanded:"));
}

}  // namespace
}  // namespace conceptplan::cli
