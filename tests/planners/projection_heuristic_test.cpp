#include "projection_heuristic.hpp"

#include <gmock/gmock.h>

#include "path_search.hpp"
#include "planners/learned_world.hpp"
#include "planners/random_world.hpp"

namespace conceptplan {
namespace {

using testing::learnedModel;
using testing::learnedRelabelling;
using testing::randomWorld;

constexpr double kThreshold = 0.01;

/// The least cost between two states, from a search that knows no heuristic.
PathCost exactDistance(const SymbolGraph& graph, StateId from, StateId goal,
                       const SuccessorFunction& successors) {
  SearchGuard guard(SearchLimits{});
  SearchStatistics statistics;
  return (
      *distancesToGoal(graph.numStates(), from, goal, successors, guard, statistics))[index(from)];
}

/// The definitions of an admissible and of a consistent heuristic: h(s) <= h*(s), and
/// h(s) <= c(s, s') + h(s') for every step.
void expectAdmissibleAndConsistent(const SymbolGraph& graph) {
  const SuccessorFunction successors = likelySuccessors(graph, kThreshold, 0.01);
  const StateId goal = graph.mostProbableGoal();
  const ProjectionHeuristic heuristic(graph, goal, successors);
  EXPECT_EQ(heuristic(goal), 0);
  std::vector<Successor> next;
  for (std::size_t i = 0; i < graph.numStates(); ++i) {
    const auto state = static_cast<StateId>(i);
    if (!graph.valid(state)) continue;
    EXPECT_LE(heuristic(state), exactDistance(graph, state, goal, successors));
    successors(state, next);
    for (const Successor& step : next) {
      const PathCost rest = heuristic(step.state);
      EXPECT_TRUE(rest == kOutOfReach || heuristic(state) <= step.cost + rest);
    }
  }
}

TEST(ProjectionHeuristic, IsAdmissibleAndConsistentOnRandomWorlds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expectAdmissibleAndConsistent(randomWorld(seed));
  }
}

Task cupTask(Cell start, Cell goal) {
  Task task;
  task.initial.objects = {{ObjectType::kCup, start, 0, 0, 0}};
  task.goal = {ObjectType::kCup, goal, 2, 0, 0};
  return task;
}

TEST(ProjectionHeuristic, FindsTheStepsOnAFreeBenchFromTheLearnedTablesAlone) {
  const SymbolGraph graph = compile(
      learnedModel(), learnedRelabelling().problem(cupTask({0, 0}, {2, 4})), GridValidity());
  const ProjectionHeuristic heuristic(graph, graph.mostProbableGoal(),
                                      anyOutcomeSuccessors(graph, kThreshold));
  // Two columns, four rows and half a turn.
  EXPECT_EQ(heuristic(graph.mostProbableStart()), 8 * kNat);
}

TEST(ProjectionHeuristic, IsAdmissibleAmongObstacles) {
  Task task = cupTask({0, 0}, {2, 0});
  task.initial.objects.push_back({ObjectType::kPot, {1, 0}, 0, 0, 0});
  task.initial.objects.push_back({ObjectType::kEgg, {1, 1}, 0, 0, 0});
  expectAdmissibleAndConsistent(
      compile(learnedModel(), learnedRelabelling().problem(task), GridValidity()));
}

}  // namespace
}  // namespace conceptplan
