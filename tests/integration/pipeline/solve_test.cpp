#include "conceptplan/pipeline/solve.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "conceptplan/planners/belief_planner.hpp"

namespace conceptplan {
namespace {

const Model& shippedModel() {
  static const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  return model;
}

Scenario shipped(const std::string& name) {
  return readScenario(std::filesystem::path(CONCEPTPLAN_SCENARIOS) / name);
}

TEST(SolveScenario, SolvesAShippedScenarioFromItsPictures) {
  const Scenario scenario = shipped("level3-0001");
  const Solution solution = solveScenario(scenario, shippedModel(), BeliefPlanner());
  ASSERT_EQ(solution.result.status, PlanStatus::kSolved) << solution.result.reason;
  ASSERT_TRUE(solution.evaluation.has_value());
  EXPECT_TRUE(solution.evaluation->best.succeeded());
  EXPECT_EQ(solution.frames.size(), solution.result.plans.front().actions.size());
  const Report report = reportOf(scenario, shippedModel(), solution, "belief", 0);
  EXPECT_EQ(report.frames.size(), solution.frames.size());
  EXPECT_THAT(renderReport(report), testing::HasSubstr("level3-0001"));
}

TEST(SolveScenario, SaysWhyThereIsNoPlan) {
  const Solution solution =
      solveScenario(shipped("infeasible-0001"), shippedModel(), BeliefPlanner());
  EXPECT_EQ(solution.result.status, PlanStatus::kInfeasible);
  EXPECT_FALSE(solution.result.reason.empty());
  EXPECT_TRUE(solution.frames.empty());
}

TEST(SolveScenario, ThePlannersThresholdIsToldInTheReport) {
  const Scenario scenario = shipped("infeasible-0001");
  Solution solution = solveScenario(scenario, shippedModel(), BeliefPlanner());
  EXPECT_EQ(reportOf(scenario, shippedModel(), solution, "belief", 0).legality_threshold,
            std::nullopt);
  solution.legality_threshold = 0.02;
  EXPECT_EQ(reportOf(scenario, shippedModel(), solution, "belief", 0).legality_threshold, 0.02);
}

TEST(SolveScenario, FindsTheTargetByItself) {
  Scenario scenario = shipped("level2-0001");
  const Solution told = solveScenario(scenario, shippedModel(), BeliefPlanner());
  scenario.target.reset();
  const Solution found = solveScenario(scenario, shippedModel(), BeliefPlanner());
  EXPECT_EQ(found.problem.initial.target, told.problem.initial.target);
  EXPECT_EQ(found.result.plans, told.result.plans);
}

TEST(SolveScenario, RefusesATargetThatIsHiddenInTheGoal) {
  Scenario scenario = shipped("level1-0001");
  auto& goal = std::get<PictureInput>(scenario.input).goal;
  std::fill(goal.mask.begin(), goal.mask.end(), std::uint8_t{0});
  EXPECT_THAT([&] { solveScenario(scenario, shippedModel(), BeliefPlanner()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("goal picture")));
}

TEST(SolveScenario, SolvesForSeveralTargetsFromPictures) {
  const Scenario scenario = shipped("two-targets/level3x2-0001");
  const Solution solution = solveScenario(scenario, shippedModel(), JointPlanner());
  ASSERT_EQ(solution.result.status, PlanStatus::kSolved) << solution.result.reason;
  EXPECT_EQ(solution.targets.size(), 2u);
  ASSERT_TRUE(solution.evaluation.has_value());
  EXPECT_TRUE(solution.evaluation->best.succeeded());
  const Plan& best = solution.result.plans.front();
  EXPECT_EQ(best.moved.size(), best.actions.size());
  EXPECT_EQ(solution.frames.size(), best.actions.size());
  const Report report = reportOf(scenario, shippedModel(), solution, "astar", 0);
  EXPECT_EQ(report.frames.size(), best.actions.size());
  EXPECT_THAT(renderReport(report), testing::HasSubstr("targets are round"));
  EXPECT_THAT([&] { solveScenario(scenario, shippedModel(), BeliefPlanner()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("targets: several targets")));
  EXPECT_THROW(solveScenario(shipped("level1-0001"), shippedModel(), JointPlanner()),
               std::invalid_argument);
}

TEST(SolveScenario, RefusesOneOfSeveralTargetsThatIsHiddenInTheGoal) {
  Scenario scenario = shipped("two-targets/level3x2-0001");
  auto& goal = std::get<PictureInput>(scenario.input).goal;
  std::replace(goal.mask.begin(), goal.mask.end(), scenario.targets[1], std::uint8_t{0});
  EXPECT_THAT([&] { solveScenario(scenario, shippedModel(), JointPlanner()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("goal picture")));
}

}  // namespace
}  // namespace conceptplan
