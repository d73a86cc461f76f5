#include "conceptplan/planners/bfs_planner.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::tinyModel;
using testing::tinyProblem;
using testing::tinySymbols;

PlanResult solve(const SymbolicProblem& problem, std::size_t top, std::size_t horizon = 24) {
  PlanQuery query;
  query.top = top;
  query.limits.horizon = horizon;
  return BfsPlanner().solve(compile(tinyModel(), problem, GridValidity()), query);
}

TEST(BfsPlanner, OrdersByLengthThenByTheOrderOfActions) {
  const PlanResult result = solve(tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 1, 0)), 3);
  ASSERT_EQ(result.plans.size(), 3u);
  EXPECT_THAT(result.plans[0].actions, ElementsAre(Action::kMoveRight, Action::kRotateLeft));
  EXPECT_THAT(result.plans[1].actions, ElementsAre(Action::kRotateLeft, Action::kMoveRight));
  EXPECT_EQ(result.plans[2].actions.size(), 4u);
  EXPECT_EQ(result.plans[0].cost, 2);
  EXPECT_NEAR(result.plans[0].probability, 0.8 * 0.9, 1e-12);
}

TEST(BfsPlanner, PredictsEachStep) {
  const PlanResult result = solve(tinyProblem(tinySymbols(0, 2, 0, 0), tinySymbols(0, 0, 0, 0)), 1);
  EXPECT_THAT(result.plans.at(0).predicted,
              ElementsAre(tinySymbols(0, 1, 0, 0), tinySymbols(0, 0, 0, 0)));
}

TEST(BfsPlanner, ThePlanThatFillsTheHorizonIsFoundAndALongerOneIsNot) {
  const SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0));
  EXPECT_EQ(solve(problem, 5, 2).plans.size(), 1u);
  const PlanResult shorter = solve(problem, 5, 1);
  EXPECT_EQ(shorter.status, PlanStatus::kInfeasible);
  EXPECT_THAT(shorter.reason, HasSubstr("within 1 actions"));
}

TEST(BfsPlanner, AConceptThatNothingHereChangesIsNamed) {
  const PlanResult result = solve(tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 0, 0, 1)), 1);
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_EQ(result.reason, "COLOR must change, and nothing here changes it");
}

TEST(BfsPlanner, RefusesAThresholdOutOfRange) {
  EXPECT_THAT(
      [] { BfsPlanner planner(BfsPlannerOptions{2}); },
      ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("legality_threshold is 2")));
}

}  // namespace
}  // namespace conceptplan
