// Nothing in the graph or the planners is made for 3 x 5 cells.
#include "planners/grid_world.hpp"

#include <gmock/gmock.h>

#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {
namespace {

using testing::gridWorld;
using testing::GridWorld;

PlanResult solve(const std::string& planner, const SymbolGraph& graph) {
  PlanQuery query;
  query.top = 1;
  query.limits.horizon = 300;
  query.limits.max_expansions = 1'000'000;
  return PlannerRegistry::standard().make(planner)->solve(graph, query);
}

TEST(GridWorld, AFreeBenchOf40x25CellsIsCrossedInAsManyStepsAsItIsWide) {
  const GridWorld world = gridWorld(40, 25, 8, 0, 1);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  EXPECT_EQ(graph.numStates(), 40u * 25 * 8);
  for (const char* planner : {"belief", "bfs", "dijkstra", "astar", "kbest", "idastar", "greedy",
                              "beam", "value-iteration", "lrtdp"}) {
    const PlanResult result = solve(planner, graph);
    ASSERT_EQ(result.status, PlanStatus::kSolved) << planner << ": " << result.reason;
    EXPECT_EQ(result.plans.front().actions.size(), 39u + 24 + 4) << planner;
  }
  EXPECT_EQ(solve("mcts", graph).status, PlanStatus::kSolved);
}

TEST(GridWorld, AmongObstaclesAstarAndBeliefAgreeWithDijkstraAndAstarExpandsLess) {
  std::size_t solved = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const GridWorld world = gridWorld(30, 20, 4, 0.2, seed);
    const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
    const PlanResult blind = solve("dijkstra", graph);
    const PlanResult guided = solve("astar", graph);
    ASSERT_EQ(guided.status, blind.status);
    const PlanResult believed = solve("belief", graph);
    ASSERT_EQ(believed.status, blind.status);
    if (blind.status != PlanStatus::kSolved) continue;
    ++solved;
    EXPECT_EQ(guided.plans.front().cost, blind.plans.front().cost);
    EXPECT_NEAR(believed.plans.front().cost, blind.plans.front().cost, 1e-6);
    EXPECT_LT(guided.statistics.expanded, blind.statistics.expanded);
  }
  EXPECT_GT(solved, 2u);
}

}  // namespace
}  // namespace conceptplan
