#include "conceptplan/planners/idastar_planner.hpp"

#include <gtest/gtest.h>

#include "planners/grid_world.hpp"

namespace conceptplan {
namespace {

TEST(IdaStarPlanner, APathMayBeAsLongAsThereAreStates) {
  // Where steps cost nothing, the first path found goes up and down all columns.
  const testing::GridWorld world = testing::gridWorld(500, 500, 1, 0, 1);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  IdaStarPlannerOptions options;
  options.step_discount = 0;
  PlanQuery query;
  query.limits.timeout_s = 1000;
  query.limits.max_expansions = 1'000'000;
  query.limits.horizon = 1'000'000;
  const PlanResult result = IdaStarPlanner(options).solve(graph, query);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_EQ(result.plans.front().cost, 0);
  EXPECT_GT(result.plans.front().actions.size(), 200'000u);
}

}  // namespace
}  // namespace conceptplan
