#include "goal_mdp.hpp"

#include <gmock/gmock.h>

#include <cfenv>
#include <limits>

#include "conceptplan/planners/planner_registry.hpp"
#include "planners/grid_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(PlansOfPolicies, HaveNoCostWhereNoValueIsAboveZero) {
  // Half of the value is lost with each of 1,199 steps, which leaves less than the least number.
  const testing::GridWorld world = testing::gridWorld(1200, 1, 1, 0, 1);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  PlanQuery query;
  query.limits.horizon = 2000;
  const PlannerRegistry registry = PlannerRegistry::standard();
  for (const char* name : {"value-iteration", "lrtdp", "mcts"}) {
    SCOPED_TRACE(name);
    std::feclearexcept(FE_ALL_EXCEPT);
    const PlanResult result = registry.make(name, {{"step_discount", "0.5"}})->solve(graph, query);
    EXPECT_EQ(result.status, PlanStatus::kLimit);
    EXPECT_THAT(result.plans, IsEmpty());
    EXPECT_THAT(result.reason, HasSubstr("not along the outcomes on which the policy rests"));
    EXPECT_FALSE(std::fetestexcept(FE_INVALID)) << "a number was rounded that is none";
  }
}

TEST(PlansOfPolicies, AHorizonMayBeTheGreatestNumber) {
  const testing::GridWorld world = testing::gridWorld(5, 5, 1, 0, 1);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  PlanQuery query;
  query.limits.horizon = std::numeric_limits<std::size_t>::max();
  EXPECT_EQ(PlannerRegistry::standard().make("value-iteration")->solve(graph, query).status,
            PlanStatus::kSolved);
}

}  // namespace
}  // namespace conceptplan
