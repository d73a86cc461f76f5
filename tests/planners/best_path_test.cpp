#include "best_path.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "path_search.hpp"
#include "planners/grid_world.hpp"
#include "planners/obstacle_map.hpp"
#include "planners/random_world.hpp"
#include "projection_heuristic.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kThreshold = 0.01;
constexpr std::size_t kFar = 1000;

PathRank noGuidance(StateId) { return 0; }

/// A graph written as its edges.
SuccessorFunction edges(std::multimap<int, Successor> by_start) {
  return [by_start](StateId state, std::vector<Successor>& next) {
    next.clear();
    const auto [first, last] = by_start.equal_range(static_cast<int>(state));
    for (auto edge = first; edge != last; ++edge) {
      next.push_back(edge->second);
      next.back().cost = rankOf(edge->second.cost, 1);
    }
  };
}

std::optional<std::vector<StatePath>> search(const SuccessorFunction& successors, int states,
                                             std::size_t horizon = kFar) {
  SearchGuard guard(SearchLimits{});
  SearchStatistics statistics;
  return bestPath(static_cast<std::size_t>(states), StateId{0}, StateId{states - 1}, 0,
                  FunctionSteps(successors), horizon, TieOrder::kNewestFirst, guard, statistics);
}

/// The first of several best paths, which are found without `bestPath`.
std::vector<StatePath> firstOfSeveral(const SymbolGraph& graph, const StateSteps& steps,
                                      TieOrder ties) {
  SearchLimits limits;
  limits.max_expansions = 1'000'000;
  SearchGuard guard(limits);
  SearchStatistics statistics;
  std::vector<StatePath> paths =
      bestPaths(graph.numStates(), graph.mostProbableStart(), graph.mostProbableGoal(), steps,
                noGuidance, {2, kFar, false, ties}, guard, statistics);
  if (paths.size() > 1) paths.resize(1);
  return paths;
}

/// What the path's actions cost, one after the other; nothing if they do not lead along its states.
std::optional<PathCost> costAlong(const StatePath& path, StateId start, const StateSteps& steps) {
  PathCost cost = 0;
  std::vector<Successor> next;
  for (std::size_t i = 0; i < path.actions.size(); ++i) {
    steps(i == 0 ? start : path.states[i - 1], next);
    const auto step = std::find_if(next.begin(), next.end(), [&](const Successor& successor) {
      return successor.action == path.actions[i] && successor.state == path.states[i];
    });
    if (step == next.end()) return std::nullopt;
    cost += costOf(step->cost);
  }
  return cost;
}

/// @param guided the steps, maybe at reduced costs.
template <typename Steps>
void expectABestPath(const SymbolGraph& graph, const StateSteps& steps, PathRank least,
                     const Steps& guided) {
  const StateId start = graph.mostProbableStart();
  const StateId goal = graph.mostProbableGoal();
  for (const TieOrder ties : {TieOrder::kOldestFirst, TieOrder::kNewestFirst}) {
    SearchGuard guard(SearchLimits{});
    SearchStatistics statistics;
    const auto found =
        bestPath(graph.numStates(), start, goal, least, guided, kFar, ties, guard, statistics);
    const std::vector<StatePath> expected = firstOfSeveral(graph, steps, ties);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), expected.size());
    if (expected.empty()) continue;
    const StatePath& path = found->front();
    EXPECT_EQ(path.cost, expected.front().cost);
    EXPECT_EQ(path.actions.size(), expected.front().actions.size());
    EXPECT_EQ(costAlong(path, start, steps), path.cost);
    EXPECT_EQ(path.states.empty() ? start : path.states.back(), goal);
    // The searches may prefer different ones of equal paths.
    if (ties == TieOrder::kNewestFirst || least != 0) continue;
    EXPECT_EQ(path.actions, expected.front().actions);
    EXPECT_EQ(path.states, expected.front().states);
  }
}

void expectABestPath(const SymbolGraph& graph) {
  const StateSteps steps = rankedSuccessors(graph, kThreshold, 0.01);
  const ProjectionHeuristic projection(graph, graph.mostProbableGoal(), steps);
  expectABestPath(graph, steps, 0, steps);
  const PathRank least = projection(graph.mostProbableStart());
  if (least == kOutOfReach) {
    EXPECT_THAT(firstOfSeveral(graph, steps, TieOrder::kOldestFirst), IsEmpty());
  } else {
    expectABestPath(graph, steps, least, GuidedSteps(steps, projection));
    expectABestPath(graph, steps, least, projection.reduced(steps));
  }
}

TEST(BestPath, IsOneOfTheBestPathsOnRandomWorlds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expectABestPath(testing::randomWorld(seed));
  }
}

TEST(BestPath, IsOneOfTheBestPathsAmongObstacles) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const testing::GridWorld world = testing::gridWorld(40, 30, 1, 0, seed);
    expectABestPath(compile(world.model, world.problem, testing::ObstacleMap(40, 30, 0.3, seed)));
  }
}

// A start that is not valid has steps that no valid state has.
TEST(BestPath, IsOneOfTheBestPathsFromAStartThatIsNotValid) {
  const testing::GridWorld world = testing::gridWorld(6, 5, 1, 0, 1);
  SymbolicProblem problem = world.problem;
  problem.initial.objects.push_back(problem.initial.objects[problem.initial.target]);
  const SymbolGraph graph = compile(world.model, problem, GridValidity());
  ASSERT_FALSE(graph.valid(graph.mostProbableStart()));
  expectABestPath(graph);
}

// On a free bench all ways that go towards the goal tie.
TEST(BestPaths, GoStraightToTheGoalWhereAllWaysTie) {
  const testing::GridWorld world = testing::gridWorld(40, 30, 1, 0, 1);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  const StateSteps steps = rankedSuccessors(graph, kThreshold, 0.01);
  const ProjectionHeuristic heuristic(graph, graph.mostProbableGoal(), steps);
  for (const std::size_t top : {1, 2}) {
    SCOPED_TRACE(top);
    SearchGuard guard(SearchLimits{});
    SearchStatistics statistics;
    const auto paths =
        bestPaths(graph.numStates(), graph.mostProbableStart(), graph.mostProbableGoal(), steps,
                  heuristic, {top, kFar}, guard, statistics);
    ASSERT_EQ(paths.size(), top);
    EXPECT_LE(statistics.expanded, top * (paths.front().actions.size() + 1));
  }
}

TEST(BestPath, TiesGoToTheShorterPathEvenAmongStepsThatCostNothing) {
  const auto paths = search(edges({{0, {Action::kMoveLeft, StateId{1}, 0}},
                                   {1, {Action::kMoveLeft, StateId{2}, 0}},
                                   {2, {Action::kMoveLeft, StateId{3}, 5}},
                                   {0, {Action::kMoveRight, StateId{2}, 5}},
                                   {2, {Action::kMoveRight, StateId{3}, 5}},
                                   {0, {Action::kMoveBack, StateId{3}, 5}}}),
                            4);
  ASSERT_TRUE(paths);
  ASSERT_EQ(paths->size(), 1u);
  EXPECT_THAT(paths->front().actions, ElementsAre(Action::kMoveBack));
}

TEST(BestPath, OfParallelStepsTheCheapestIsTaken) {
  const auto paths = search(
      edges({{0, {Action::kMoveLeft, StateId{1}, 7}}, {0, {Action::kMoveRight, StateId{1}, 3}}}),
      2);
  ASSERT_TRUE(paths);
  EXPECT_EQ(paths->front().cost, 3);
  EXPECT_THAT(paths->front().actions, ElementsAre(Action::kMoveRight));
}

TEST(BestPath, FindsThatThereIsNone) {
  const auto paths = search(edges({{0, {Action::kMoveLeft, StateId{1}, 1}}}), 3);
  ASSERT_TRUE(paths);
  EXPECT_THAT(*paths, IsEmpty());
}

TEST(BestPath, CannotTellWhereTheHorizonMayHideAShorterWayThatCostsMore) {
  const SuccessorFunction successors = edges({{0, {Action::kMoveLeft, StateId{1}, 1}},
                                              {1, {Action::kMoveLeft, StateId{2}, 1}},
                                              {0, {Action::kMoveRight, StateId{2}, 9}},
                                              {2, {Action::kMoveLeft, StateId{3}, 1}}});
  EXPECT_FALSE(search(successors, 4, 2));
  EXPECT_TRUE(search(successors, 4, 3));
  SearchGuard guard(SearchLimits{});
  SearchStatistics statistics;
  const auto paths = bestPaths(4, StateId{0}, StateId{3}, FunctionSteps(successors), noGuidance,
                               {1, 2}, guard, statistics);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_THAT(paths.front().actions, ElementsAre(Action::kMoveRight, Action::kMoveLeft));
}

TEST(BestPath, WhatItExpandedCountsAlsoWhereItCannotTell) {
  const FunctionSteps steps(edges({{0, {Action::kMoveLeft, StateId{1}, 1}},
                                   {1, {Action::kMoveLeft, StateId{2}, 1}},
                                   {0, {Action::kMoveRight, StateId{2}, 9}},
                                   {2, {Action::kMoveLeft, StateId{3}, 1}}}));
  const auto searched = [&](std::size_t max_expansions) {
    SearchLimits limits;
    limits.max_expansions = max_expansions;
    SearchGuard guard(limits);
    SearchStatistics both;
    const auto paths = bestPaths(4, StateId{0}, StateId{3}, steps, noGuidance, {1, 2}, guard, both);
    return std::pair(both.expanded, paths.size());
  };
  SearchGuard guard(SearchLimits{});
  SearchStatistics one, several;
  EXPECT_FALSE(
      bestPath(4, StateId{0}, StateId{3}, 0, steps, 2, TieOrder::kNewestFirst, guard, one));
  severalPaths(4, StateId{0}, StateId{3}, steps, noGuidance, {1, 2}, guard, several);
  const std::size_t all = one.expanded + several.expanded;
  EXPECT_EQ(searched(all), std::pair(all, std::size_t{1}));
  EXPECT_EQ(searched(all - 1), std::pair(all - 1, std::size_t{0}));
}

TEST(BestPath, CannotTellOfCostsBeyondWhatARankHolds) {
  std::multimap<int, Successor> steps;
  for (int i = 0; i < 9; ++i) {
    steps.insert({i, {Action::kMoveLeft, StateId{i + 1}, 7'000 * kNat}});
  }
  const SuccessorFunction successors = edges(steps);
  EXPECT_FALSE(search(successors, 10));
  SearchGuard guard(SearchLimits{});
  SearchStatistics statistics;
  const auto paths = bestPaths(10, StateId{0}, StateId{9}, FunctionSteps(successors), noGuidance,
                               {1, kFar}, guard, statistics);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths.front().cost, 63'000 * kNat);
}

TEST(LeastCosts, AreCutOffAtTheFarthest) {
  const std::vector<StateEdge> edges{{StateId{0}, StateId{1}, kFarthest - 1},
                                     {StateId{1}, StateId{2}, kFarthest - 1}};
  SearchGuard guard(SearchLimits{});
  EXPECT_THAT(leastCosts(4, StateId{2}, edges, guard),
              ElementsAre(kFarthest, kFarthest - 1, 0, kOutOfReach));
}

}  // namespace
}  // namespace conceptplan
