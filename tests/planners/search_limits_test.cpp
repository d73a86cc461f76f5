// Limits are asked for in whatever takes long, not only between expansions.
#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "belief_search.hpp"
#include "conceptplan/planners/belief_planner.hpp"
#include "conceptplan/planners/joint_planner.hpp"
#include "joint_space.hpp"
#include "legality_trace.hpp"
#include "path_search.hpp"
#include "planners/grid_world.hpp"
#include "planners/joint_world.hpp"
#include "projection_heuristic.hpp"

namespace conceptplan {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A bench of 28,800 states, on which a plan takes 122 actions.
SymbolGraph largeBench() {
  const testing::GridWorld world = testing::gridWorld(60, 60, 8, 0, 1);
  return compile(world.model, world.problem, GridValidity());
}
constexpr std::size_t kLargeBenchActions = 59 + 59 + 4;

PlanQuery largeQuery() {
  PlanQuery query;
  query.limits.timeout_s = 1000;
  query.limits.horizon = 200;
  query.limits.max_expansions = 1'000'000'000;
  return query;
}

/// A guard of a search that was cancelled before it began.
class Cancelled {
 public:
  SearchGuard& guard() { return guard_; }

 private:
  static SearchLimits limits(const std::atomic<bool>& cancel) {
    SearchLimits limits;
    limits.cancel = &cancel;
    return limits;
  }

  const std::atomic<bool> cancel_{true};
  SearchGuard guard_{limits(cancel_)};
};

TEST(SearchLimits, NoValuesOfStatesAfterACancel) {
  const SymbolGraph graph = largeBench();
  BeliefSearchOptions options;
  options.horizon = 200;
  Cancelled cancelled;
  EXPECT_FALSE(beliefValues(graph, {{graph.mostProbableGoal(), 1}}, options, cancelled.guard()));
  EXPECT_EQ(cancelled.guard().reason(), "cancelled");
}

TEST(SearchLimits, NothingIsInReachAfterACancel) {
  const SymbolGraph graph = largeBench();
  Cancelled cancelled;
  EXPECT_FALSE(isInReach(graph, graph.mostProbableStart(), graph.mostProbableGoal(), 0.01, 200,
                         cancelled.guard()));
  EXPECT_EQ(cancelled.guard().stopped(), PlanStatus::kLimit);
  SearchGuard guard(SearchLimits{});
  EXPECT_TRUE(isInReach(graph, graph.mostProbableStart(), graph.mostProbableGoal(), 0.01,
                        kLargeBenchActions, guard));
  EXPECT_FALSE(isInReach(graph, graph.mostProbableStart(), graph.mostProbableGoal(), 0.01,
                         kLargeBenchActions - 1, guard));
}

TEST(SearchLimits, AnExplanationIsCutShortByACancel) {
  const SymbolGraph graph = largeBench();
  Cancelled cancelled;
  PlanResult result;
  PlanQuery query;
  query.limits.horizon = 5;
  explainInfeasible(graph, query, 0.01, cancelled.guard(), result);
  EXPECT_EQ(result.reason, "no legal and valid steps lead to the goal within 5 actions");
  EXPECT_THAT(result.nearest, IsEmpty());
  SearchGuard guard(SearchLimits{});
  explainInfeasible(graph, query, 0.01, guard, result);
  EXPECT_THAT(result.reason, HasSubstr("it takes at least 122"));
  EXPECT_THAT(result.nearest, Not(IsEmpty()));
}

TEST(SearchLimits, ABeliefSearchEndsWhenAnotherThreadCancelsIt) {
  const SymbolGraph graph = largeBench();
  std::atomic<bool> cancel{false};
  PlanQuery query = largeQuery();
  query.limits.cancel = &cancel;
  auto answer = std::async(std::launch::async, [&] { return BeliefPlanner().solve(graph, query); });
  std::this_thread::sleep_for(20ms);
  cancel = true;
  const PlanResult result = answer.get();
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");
  EXPECT_THAT(result.plans, IsEmpty());
  EXPECT_LT(result.statistics.expanded, kLargeBenchActions);
}

TEST(SearchLimits, ABeliefSearchEndsSoonAfterItsTime) {
  PlanQuery query = largeQuery();
  query.limits.timeout_s = 0.02;
  const PlanResult result = BeliefPlanner().solve(largeBench(), query);
  EXPECT_EQ(result.status, PlanStatus::kTimeout);
  EXPECT_LT(result.statistics.expanded, kLargeBenchActions);
}

/// Cancels the search at its first check, and counts the checks.
class CancellingValidity final : public StateValidity {
 public:
  Verdict check(const Workbench&, const SymbolGrounding&, const Symbols&,
                std::span<const Symbols>) const override {
    cancel = true;
    ++checks;
    return {};
  }
  std::array<bool, kNumConcepts> dependsOn() const override { return GridValidity().dependsOn(); }

  mutable std::atomic<bool> cancel{false};
  mutable std::atomic<std::size_t> checks{0};
};

TEST(SearchLimits, ACancelEndsTheMakingOfAJointSpace) {
  const testing::JointWorld world =
      testing::jointGrid(100, 100, 1, {{{0, 0}, {99, 99}}, {{1, 1}, {3, 3}}});
  const CancellingValidity validity;
  PlanQuery query = largeQuery();
  query.limits.cancel = &validity.cancel;
  const PlanResult result = JointPlanner().solve(world.model, world.problem, validity, query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");
  EXPECT_EQ(result.statistics.expanded, 0u);
  EXPECT_EQ(result.statistics.validity_checks, validity.checks);
  EXPECT_LT(validity.checks, 1000u);
}

TEST(SearchLimits, ACancelEndsCompilation) {
  const testing::GridWorld world = testing::gridWorld(100, 100, 1, 0, 1);
  const CancellingValidity validity;
  SearchLimits limits;
  limits.cancel = &validity.cancel;
  SearchGuard guard(limits);
  EXPECT_FALSE(compile(world.model, world.problem, validity, guard));
  EXPECT_EQ(guard.reason(), "cancelled");
  EXPECT_GT(validity.checks, 0u);
  EXPECT_LT(validity.checks, 100u * 100u);
  Cancelled cancelled;
  const CancellingValidity never_asked;
  EXPECT_FALSE(compile(world.model, world.problem, never_asked, cancelled.guard()));
  EXPECT_EQ(never_asked.checks, 0u);
}

TEST(SearchLimits, NoHeuristicAfterACancel) {
  const SymbolGraph graph = largeBench();
  const StateSteps steps = likelySuccessors(graph, 0.01, 0.01);
  Cancelled cancelled;
  const ProjectionHeuristic heuristic(graph, graph.mostProbableGoal(), steps, &cancelled.guard());
  EXPECT_EQ(heuristic(graph.mostProbableStart()), kOutOfReach);
  EXPECT_EQ(cancelled.guard().reason(), "cancelled");
}

TEST(SearchLimits, NoStepsAfterACancel) {
  const SymbolGraph graph = largeBench();
  std::vector<Successor> next;
  Cancelled cancelled;
  for (const StateSteps& steps : {likelySuccessors(graph, 0.01, 0.01, &cancelled.guard()),
                                  rankedSuccessors(graph, 0.01, 0.01, &cancelled.guard()),
                                  anyOutcomeSuccessors(graph, 0.01, &cancelled.guard())}) {
    steps(graph.mostProbableStart(), next);
    EXPECT_THAT(next, IsEmpty());
  }
  const StateSteps steps = rankedSuccessors(graph, 0.01, 0.01);
  const ProjectionHeuristic heuristic(graph, graph.mostProbableGoal(), steps);
  heuristic.reduced(steps, &cancelled.guard())(graph.mostProbableStart(), next);
  EXPECT_THAT(next, IsEmpty());
  heuristic.reduced(steps)(graph.mostProbableStart(), next);
  EXPECT_THAT(next, Not(IsEmpty()));
}

TEST(SearchLimits, NoMoreThanTheStartIsReachedAfterACancel) {
  const SymbolGraph graph = largeBench();
  const auto reached = [&](SearchGuard* guard) {
    return reachableStates(graph, graph.mostProbableStart(), 0.01, 200, graph.numStates(), guard)
        .size();
  };
  Cancelled cancelled;
  EXPECT_EQ(reached(&cancelled.guard()), 1u);
  EXPECT_EQ(reached(nullptr), graph.numStates());
}

TEST(SearchLimits, WhatWasRuledOutIsNotCountedAfterACancel) {
  const SymbolGraph graph = largeBench();
  for (const bool cancels : {false, true}) {
    std::atomic<bool> cancel{false};
    PlanQuery query = largeQuery();
    query.count_rejections = true;
    query.limits.cancel = &cancel;
    const PlanResult result = withTally(graph, query, 0.01, [&](SearchGuard& guard) {
      PlanResult answer;
      for (std::size_t i = 0; i < graph.numStates(); ++i) {
        guard.expand(answer.statistics, static_cast<StateId>(i));
      }
      cancel = cancels;
      return answer;
    });
    EXPECT_EQ(result.ruled_out.has_value(), !cancels);
  }
}

TEST(SearchLimits, NoLeastCostsAfterACancel) {
  const std::vector<StateEdge> edges{{StateId{0}, StateId{1}, 1}};
  Cancelled cancelled;
  EXPECT_EQ(leastCosts(2, StateId{1}, edges, cancelled.guard())[0], kOutOfReach);
  SearchGuard guard(SearchLimits{});
  EXPECT_EQ(leastCosts(2, StateId{1}, edges, guard)[0], 1);
}

TEST(SearchLimits, NoJointSpaceAfterItsTime) {
  const testing::JointWorld world =
      testing::jointGrid(100, 100, 4, {{{0, 0}, {99, 99}}, {{1, 1}, {3, 3}}});
  const GridValidity validity;
  SearchLimits limits;
  limits.timeout_s = 1e-9;
  SearchGuard guard(limits);
  SearchStatistics statistics;
  EXPECT_FALSE(JointSpace::make(world.model, world.problem, validity,
                                {0.01, 1e-6, 1e-3, [](double) { return kNat; }}, guard,
                                statistics));
  EXPECT_EQ(guard.stopped(), PlanStatus::kTimeout);
}

/// Three targets on a crowded bench, searched for without guidance.
PlanResult solvedBlindly(const PlanQuery& query) {
  const testing::JointWorld world = testing::drawnJointGrid(5, 5, 4, 3, 3, 1);
  JointPlannerOptions options;
  options.guided = false;
  return JointPlanner(options).solve(world.model, world.problem, GridValidity(), query);
}

TEST(SearchLimits, AJointSearchEndsWhenAnotherThreadCancelsIt) {
  std::atomic<bool> cancel{false};
  PlanQuery query = largeQuery();
  query.limits.cancel = &cancel;
  auto answer = std::async(std::launch::async, [&] { return solvedBlindly(query); });
  std::this_thread::sleep_for(20ms);
  cancel = true;
  const PlanResult result = answer.get();
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");
  EXPECT_LT(result.statistics.expanded, 100'000u);
}

TEST(SearchLimits, AJointSearchEndsSoonAfterItsTime) {
  PlanQuery query = largeQuery();
  query.limits.timeout_s = 0.02;
  const PlanResult result = solvedBlindly(query);
  EXPECT_EQ(result.status, PlanStatus::kTimeout);
  EXPECT_LT(result.statistics.expanded, 100'000u);
}

}  // namespace
}  // namespace conceptplan
