#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "integration/cli/command_runner.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kScenario = CONCEPTPLAN_SCENARIOS "/level3-0001";

/// A folder for what `export plan` writes.
class ExportPlanCommand : public testing::Test {
 protected:
  CommandResult exportPlan(const std::string& scenario,
                           const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"export", "plan",         scenario,
                                       "--out",  out().string(), "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runCommand(arguments);
  }

  std::filesystem::path out() const { return folder_ / "out"; }

  /// What the search of a planner ended with.
  std::string status(const std::string& scenario, const std::vector<std::string>& options) const {
    return json::parse(exportPlan(scenario, options).out)["status"];
  }

  const TemporaryFolder folder_;
};

TEST_F(ExportPlanCommand, PlansOfAnEarlierRunDoNotStay) {
  ASSERT_EQ(exportPlan(kScenario, {"--planner", "kbest"}).exit_code, 0);
  ASSERT_TRUE(std::filesystem::exists(out() / "plan.5"));
  writeFileAtomically(out() / "plan.txt", "mine");
  ASSERT_EQ(exportPlan(kScenario, {"--planner", "idastar"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(out() / "plan.1"));
  for (const char* stale : {"plan.2", "plan.3", "plan.4", "plan.5"}) {
    EXPECT_FALSE(std::filesystem::exists(out() / stale)) << stale;
  }
  EXPECT_EQ(readFile(out() / "plan.txt"), "mine");
}

TEST_F(ExportPlanCommand, TheSearchHasTheThresholdOfThePlanFiles) {
  // No action is more probable than 1.
  EXPECT_EQ(status(kScenario, {"--planner", "astar"}), "solved");
  EXPECT_EQ(status(kScenario, {"--planner", "astar", "--legality-threshold", "1"}), "infeasible");
  EXPECT_EQ(status(kScenario, {"--planner", "belief", "--legality-threshold", "1"}), "infeasible");

  std::filesystem::copy(kScenario, folder_ / "scenario");
  std::string text = readFile(folder_ / "scenario/scenario.yaml");
  const std::string planner = "name: belief";
  text.replace(text.find(planner), planner.size(), planner + ", options: {legality_threshold: 1}");
  writeFileAtomically(folder_ / "scenario/scenario.yaml", text);
  const std::string strict = (folder_ / "scenario").string();
  EXPECT_EQ(status(strict, {"--planner", "astar"}), "infeasible");
  EXPECT_EQ(status(strict, {"--planner", "astar", "--legality-threshold", "0.01"}), "solved");
}

TEST_F(ExportPlanCommand, ADiscountThatThePlannerCannotHaveIsNamed) {
  const CommandResult result =
      exportPlan(kScenario, {"--planner", "value-iteration", "--step-discount", "0"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, HasSubstr("--planner: planner.options.step_discount: expected a number "
                                      "in [0.0001, 0.5], found \"0.0\""));
}

}  // namespace
}  // namespace conceptplan::cli
