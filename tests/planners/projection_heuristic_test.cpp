#include "projection_heuristic.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "path_search.hpp"
#include "planners/grid_world.hpp"
#include "planners/random_world.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using testing::gridWorld;
using testing::randomWorld;

constexpr double kThreshold = 0.01;

/// The least cost between two states, from a search that knows no heuristic.
PathCost exactDistance(const SymbolGraph& graph, StateId from, StateId goal,
                       const StateSteps& successors) {
  SearchGuard guard(SearchLimits{});
  SearchStatistics statistics;
  return (*distancesToGoal(graph.numStates(), from, goal, std::cref(successors), guard,
                           statistics))[index(from)];
}

/// The definitions of an admissible and of a consistent heuristic: h(s) <= h*(s), and
/// h(s) <= c(s, s') + h(s') for every step.
void expectAdmissibleAndConsistent(const SymbolGraph& graph, StateId goal,
                                   const StateSteps& successors) {
  const ProjectionHeuristic heuristic(graph, goal, successors);
  EXPECT_EQ(heuristic(goal), 0);
  std::vector<Successor> next;
  for (std::size_t i = 0; i < graph.numStates(); ++i) {
    const auto state = static_cast<StateId>(i);
    if (!graph.valid(state) || graph.readingOf(state) != graph.readingOf(goal)) continue;
    EXPECT_LE(heuristic(state), exactDistance(graph, state, goal, successors));
    successors(state, next);
    for (const Successor& step : next) {
      const PathCost rest = heuristic(step.state);
      EXPECT_TRUE(rest == kOutOfReach || heuristic(state) <= step.cost + rest);
    }
  }
}

/// Steps at reduced costs are those that know the distances of all concepts, at c + h(s') - h(s).
void expectReducedCosts(const SymbolGraph& graph, StateId goal, const StateSteps& successors) {
  const ProjectionHeuristic heuristic(graph, goal, successors);
  const StateSteps reduced = heuristic.reduced(successors);
  const GuidedSteps expected(successors, heuristic);
  std::vector<Successor> next;
  for (std::size_t i = 0; i < graph.numStates(); ++i) {
    const auto state = static_cast<StateId>(i);
    if (graph.readingOf(state) != graph.readingOf(goal) || heuristic(state) == kOutOfReach)
      continue;
    reduced(state, next);
    auto step = next.begin();
    expected.forEach(state, [&](const Successor& wanted) {
      if (!graph.valid(wanted.state)) return;
      ASSERT_NE(step, next.end());
      EXPECT_EQ(step->action, wanted.action);
      EXPECT_EQ(step->state, wanted.state);
      EXPECT_EQ(step->cost, wanted.cost);
      EXPECT_GE(step->cost, 0);
      ++step;
    });
    EXPECT_EQ(step, next.end());
  }
}

void expectAdmissibleAndConsistent(const SymbolGraph& graph, StateId goal) {
  expectReducedCosts(graph, goal, rankedSuccessors(graph, kThreshold, 0.01));
  expectAdmissibleAndConsistent(graph, goal, likelySuccessors(graph, kThreshold, 0.01));
  expectAdmissibleAndConsistent(graph, goal, rankedSuccessors(graph, kThreshold, 0.01));
}

TEST(ProjectionHeuristic, IsAdmissibleAndConsistentOnRandomWorlds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    expectAdmissibleAndConsistent(graph, graph.mostProbableGoal());
  }
}

TEST(ProjectionHeuristic, IsExactOnAFreeBenchFromTheTablesAlone) {
  const testing::GridWorld world = gridWorld(3, 5, 4, 0, 1);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  const ProjectionHeuristic heuristic(graph, graph.mostProbableGoal(),
                                      anyOutcomeSuccessors(graph, kThreshold));
  // Two columns, four rows and half a turn.
  EXPECT_EQ(heuristic(graph.mostProbableStart()), 8 * kNat);
}

// In the second reading there is a dyer, so that the target's colour can be changed.
TEST(ProjectionHeuristic, IsThatOfTheReadingThatTheGoalIsIn) {
  using testing::tinySymbols;
  SymbolicProblem problem = testing::tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 1, 1));
  SymbolBelief dyer = certain(tinySymbols(1, 2, 0, 1), testing::kTinyCardinality);
  dyer[index(Concept::kType)] = {0.7, 0.3};
  problem.initial.objects.push_back(dyer);
  const SymbolGraph graph = compile(testing::tinyModel(), problem, GridValidity());
  ASSERT_EQ(graph.numReadings(), 2u);
  const StateSteps successors = likelySuccessors(graph, kThreshold, 0.01);
  for (const bool has_dyer : {false, true}) {
    const StateId goal = graph.inReading(graph.mostProbableGoal(), has_dyer ? 1 : 0);
    const StateId start = graph.inReading(graph.mostProbableStart(), has_dyer ? 1 : 0);
    const ProjectionHeuristic heuristic(graph, goal, successors);
    EXPECT_EQ(heuristic(start) == kOutOfReach, !has_dyer);
    expectAdmissibleAndConsistent(graph, goal);
  }
}

TEST(ProjectionHeuristic, IsAdmissibleAndConsistentAmongObstacles) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const testing::GridWorld world = gridWorld(4, 5, 3, 0.3, seed);
    const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
    expectAdmissibleAndConsistent(graph, graph.mostProbableGoal());
  }
}

}  // namespace
}  // namespace conceptplan
