#include <gtest/gtest.h>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/planners/best_first_planner.hpp"
#include "conceptplan/planners/pddl/plan_replay.hpp"
#include "fuzz/damage.hpp"
#include "planners/random_world.hpp"

namespace conceptplan {
namespace {

TEST(PlanFileFuzz, DamagedFilesAreRefusedOrReadAndReplayedOrNamed) {
  const SymbolGraph graph = testing::randomWorld(2);
  const PlanResult result = BestFirstPlanner().solve(graph, {});
  ASSERT_FALSE(result.plans.empty());
  const PlanFile whole = groundPlan(graph, result.plans.back().actions);
  std::size_t refused = 0, failed = 0;
  testing::forEachDamage(planFileText(whole), 200, 2000, 9,
                         [&](const std::string& text, const std::string& what) {
                           SCOPED_TRACE(what);
                           try {
                             const PlanFile plan = parsePlanFile(text, "plan");
                             PlanFile again = parsePlanFile(planFileText(plan), "plan");
                             for (std::size_t i = 0; i < again.steps.size(); ++i) {
                               again.steps[i].line = plan.steps[i].line;
                             }
                             EXPECT_EQ(again, plan);
                             const PlanReplay replayed = replay(graph, plan.steps);
                             EXPECT_LE(replayed.states.size(), plan.steps.size());
                             failed += replayed.failure ? 1 : 0;
                             if (!replayed.failure) {
                               EXPECT_EQ(replayed.states.size(), plan.steps.size());
                             }
                           } catch (const InputError& error) {
                             ++refused;
                             for (const Fault& fault : error.faults()) {
                               EXPECT_TRUE(fault.line && fault.column && *fault.column > 0);
                             }
                           }
                         });
  EXPECT_GT(refused, 500U);
  EXPECT_GT(failed, 50U);
}

}  // namespace
}  // namespace conceptplan
