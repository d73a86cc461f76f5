// What every registered planner must keep, whatever else it does.
#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <set>
#include <stdexcept>
#include <thread>

#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "planners/grid_world.hpp"
#include "planners/learned_world.hpp"
#include "planners/sample_tasks.hpp"

namespace conceptplan {
namespace {

using testing::learnedModel;
using testing::learnedRelabelling;
using testing::lockedInTask;
using testing::testTask;

SymbolGraph graphOf(const Task& task) {
  return compile(learnedModel(), learnedRelabelling().problem(task), GridValidity());
}

class PlannerContract : public ::testing::TestWithParam<std::string> {
 protected:
  PlanResult solve(const Task& task, const PlanQuery& query = {}) const {
    return planner_->solve(graphOf(task), query);
  }

  const std::unique_ptr<Planner> planner_ = PlannerRegistry::standard().make(GetParam());
};

TEST_P(PlannerContract, StartEqualsGoalGivesTheEmptyPlanFirst) {
  Task task = testTask(2, 0);
  task.goal = task.initial.objects[task.initial.target];
  const PlanResult result = solve(task);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_TRUE(result.plans.front().actions.empty());
  EXPECT_TRUE(result.plans.front().predicted.empty());
}

TEST_P(PlannerContract, AGoalOutOfReachIsProvedInfeasible) {
  const PlanResult result = solve(lockedInTask());
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_TRUE(result.plans.empty());
  EXPECT_FALSE(result.reason.empty());
  EXPECT_TRUE(std::any_of(
      result.rejections.begin(), result.rejections.end(), [](const Rejection& rejection) {
        return rejection.cause == Invalidity::kCollision || rejection.cause == Invalidity::kNone;
      }));
}

TEST_P(PlannerContract, EveryFirstPlanSolvesItsTaskInTheSimulator) {
  for (int level = 1; level <= 4; ++level) {
    for (int i = 0; i < 50; ++i) {
      const Task task = testTask(level, i);
      const PlanResult result = solve(task);
      ASSERT_EQ(result.status, PlanStatus::kSolved) << task.id << ": " << result.reason;
      EXPECT_TRUE(judge(task, result.plans.front().actions).succeeded()) << task.id;
    }
  }
}

TEST_P(PlannerContract, EveryPlanReplaysToThePredictedSymbols) {
  for (int i = 0; i < 50; ++i) {
    const Task task = testTask(4, i);
    for (const Plan& plan : solve(task).plans) {
      ASSERT_EQ(plan.predicted.size(), plan.actions.size());
      World world = task.initial;
      for (std::size_t step = 0; step < plan.actions.size(); ++step) {
        ASSERT_FALSE(advance(world, plan.actions[step])) << task.id;
        EXPECT_EQ(plan.predicted[step], learnedRelabelling().symbols(world.objects[world.target]));
      }
      EXPECT_EQ(world.objects[world.target], task.goal);
      EXPECT_NEAR(plan.probability, 1, 1e-9);
    }
  }
}

TEST_P(PlannerContract, PlansAreDistinctAsManyAsAskedForAndBestFirst) {
  for (int i = 0; i < 20; ++i) {
    PlanQuery query;
    query.top = 7;
    const PlanResult result = solve(testTask(3, i), query);
    EXPECT_EQ(result.plans.size(), GetParam() == "idastar" ? 1u : 7u);
    std::set<ActionSequence> distinct;
    for (const Plan& plan : result.plans) distinct.insert(plan.actions);
    EXPECT_EQ(distinct.size(), result.plans.size());
    EXPECT_TRUE(
        std::is_sorted(result.plans.begin(), result.plans.end(),
                       [](const Plan& a, const Plan& b) { return a.cost < b.cost - 1e-9; }));
  }
}

/// The planners that promise the best plan; where nothing is uncertain that is a shortest one.
class OptimalPlannerContract : public PlannerContract {};

TEST_P(OptimalPlannerContract, PlansAreAsShortAsTheReferenceWhereNothingIsUncertain) {
  for (int level = 1; level <= 4; ++level) {
    for (int i = 0; i < 50; ++i) {
      const Task task = testTask(level, i);
      EXPECT_EQ(solve(task).plans.at(0).actions.size(), task.reference.size()) << task.id;
    }
  }
}

TEST_P(PlannerContract, TheSameCallGivesTheSameResult) {
  const Task task = testTask(4, 3);
  EXPECT_EQ(solve(task), solve(task));
}

TEST_P(PlannerContract, ThreadsMayShareOne) {
  const SymbolGraph graph = graphOf(testTask(4, 5));
  const PlanResult alone = planner_->solve(graph, {});
  std::vector<std::future<PlanResult>> results;
  for (int i = 0; i < 4; ++i) {
    results.push_back(std::async(std::launch::async, [&] { return planner_->solve(graph, {}); }));
  }
  for (auto& result : results) EXPECT_EQ(result.get(), alone);
}

TEST_P(PlannerContract, OneTwoAndEightThreadsGiveTheSameResults) {
  constexpr std::size_t kTasks = 16;
  std::vector<SymbolGraph> graphs;
  for (std::size_t i = 0; i < kTasks; ++i)
    graphs.push_back(graphOf(testTask(4, static_cast<int>(i))));
  const auto solve_all = [&](std::size_t threads) {
    std::vector<PlanResult> results(kTasks);
    std::vector<std::future<void>> workers;
    for (std::size_t first = 0; first < threads; ++first) {
      workers.push_back(std::async(std::launch::async, [&, first] {
        for (std::size_t i = first; i < kTasks; i += threads) {
          results[i] = planner_->solve(graphs[i], {});
        }
      }));
    }
    for (auto& worker : workers) worker.get();
    return results;
  };
  const std::vector<PlanResult> alone = solve_all(1);
  EXPECT_EQ(solve_all(2), alone);
  EXPECT_EQ(solve_all(8), alone);
}

TEST_P(PlannerContract, TheLimitOfExpansionsIsHonoured) {
  PlanQuery query;
  query.limits.max_expansions = 1;
  const PlanResult result = solve(testTask(3, 1), query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_LE(result.statistics.expanded, 1u);
  EXPECT_THAT(result.reason, ::testing::HasSubstr("limit of 1 expansions"));
}

TEST_P(PlannerContract, ATimeLimitIsHonoured) {
  PlanQuery query;
  query.limits.timeout_s = 1e-9;
  const PlanResult result = solve(testTask(3, 1), query);
  EXPECT_EQ(result.status, PlanStatus::kTimeout);
  EXPECT_THAT(result.reason, ::testing::HasSubstr("time limit"));
}

TEST_P(PlannerContract, ACancelIsHonoured) {
  const std::atomic<bool> cancel{true};
  PlanQuery query;
  query.limits.cancel = &cancel;
  const PlanResult result = solve(testTask(3, 1), query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");
}

/// A bench of 40,000 cells, of which a plan passes 398; back from the last to the first.
const SymbolGraph& longWay() {
  static const testing::GridWorld world = testing::gridWorld(200, 200, 1, 0, 1);
  static const SymbolGraph there = compile(world.model, world.problem, GridValidity());
  static const SymbolGraph back =
      there.between(there.mostProbableGoal(), there.mostProbableStart());
  return back;
}

TEST_P(PlannerContract, TheLimitOfExpansionsIsHonouredInMidSearch) {
  PlanQuery query;
  query.limits.horizon = 1000;
  query.limits.timeout_s = 1000;
  query.limits.max_expansions = 300;
  query.count_rejections = true;
  const PlanResult result = planner_->solve(longWay(), query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "stopped at the limit of 300 expansions");
  EXPECT_EQ(result.statistics.expanded, 300u);
  ASSERT_TRUE(result.ruled_out);
  EXPECT_LE(result.ruled_out->states, 300u);
}

/// A bench of 1,280,000 states, all in reach but the goal, which stands in a corner shut off.
const SymbolGraph& longProof() {
  static const testing::GridWorld world = [] {
    testing::GridWorld shut = testing::gridWorld(200, 200, 32, 0, 1);
    for (const int x : {198, 199}) {
      Symbols obstacle{};
      obstacle[index(Concept::kPositionX)] = SymbolId{x};
      obstacle[index(Concept::kPositionY)] = SymbolId{x == 199 ? 198 : 199};
      shut.problem.initial.objects.push_back(certain(obstacle, shut.model.cardinality()));
    }
    return shut;
  }();
  static const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  return graph;
}

/// Enough for any search but for what stops it.
PlanQuery withoutLimits() {
  PlanQuery query;
  query.limits.horizon = 1'000'000;
  query.limits.timeout_s = 1000;
  query.limits.max_expansions = 1'000'000'000;
  query.count_rejections = true;
  return query;
}

/// How long a search may go on after its limit, on a machine that has other work too.
constexpr std::chrono::seconds kSoon{20};

TEST_P(PlannerContract, ACancelFromAnotherThreadEndsTheSearchSoon) {
  const SymbolGraph& graph = longProof();
  std::atomic<bool> cancel{false};
  PlanQuery query = withoutLimits();
  query.limits.cancel = &cancel;
  auto answer = std::async(std::launch::async, [&] { return planner_->solve(graph, query); });
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  cancel = true;
  EXPECT_EQ(answer.wait_for(kSoon), std::future_status::ready);
  const PlanResult result = answer.get();
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");
  EXPECT_TRUE(result.plans.empty());
}

TEST_P(PlannerContract, TheTimeLimitEndsTheSearchSoonInMidSearch) {
  const SymbolGraph& graph = longProof();
  PlanQuery query = withoutLimits();
  query.limits.timeout_s = 0.005;
  const auto start = std::chrono::steady_clock::now();
  const PlanResult result = planner_->solve(graph, query);
  EXPECT_LT(std::chrono::steady_clock::now() - start, kSoon);
  EXPECT_EQ(result.status, PlanStatus::kTimeout);
  EXPECT_TRUE(result.plans.empty());
}

TEST_P(PlannerContract, TheHorizonIsHonoured) {
  const Task task = testTask(4, 2);
  ASSERT_GT(task.reference.size(), 1u);
  PlanQuery query;
  query.limits.horizon = task.reference.size() - 1;
  EXPECT_EQ(solve(task, query).status, PlanStatus::kInfeasible);
  query.limits.horizon = task.reference.size();
  const PlanResult result = solve(task, query);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  for (const Plan& plan : result.plans) EXPECT_LE(plan.actions.size(), task.reference.size());
}

TEST_P(PlannerContract, QueriesForNothingAreRefused) {
  PlanQuery no_plan;
  no_plan.top = 0;
  EXPECT_THAT(
      [&] { solve(testTask(1, 0), no_plan); },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("at least one plan")));
  PlanQuery no_time;
  no_time.limits.timeout_s = 0;
  EXPECT_THAT(
      [&] { solve(testTask(1, 0), no_time); },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("timeout_s is 0")));
  PlanQuery no_expansions;
  no_expansions.limits.max_expansions = 0;
  EXPECT_THAT(
      [&] { solve(testTask(1, 0), no_expansions); },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("max_expansions is 0")));
}

std::vector<std::string> plannerNames() {
  std::vector<std::string> names;
  const PlannerRegistry registry = PlannerRegistry::standard();
  for (const PlannerEntry& entry : registry.entries()) {
    names.push_back(entry.name);
  }
  return names;
}

std::string identifier(std::string planner) {
  std::replace(planner.begin(), planner.end(), '-', '_');
  return planner;
}

INSTANTIATE_TEST_SUITE_P(EveryPlanner, PlannerContract, ::testing::ValuesIn(plannerNames()),
                         [](const auto& planner) { return identifier(planner.param); });

INSTANTIATE_TEST_SUITE_P(EveryOptimalPlanner, OptimalPlannerContract,
                         ::testing::Values("belief", "bfs", "dijkstra", "astar", "kbest", "idastar",
                                           "value-iteration", "lrtdp"),
                         [](const auto& planner) { return identifier(planner.param); });

TEST(EveryPlannerTogether, SolvesAllTasksThatAnyOfThemSolves) {
  const PlannerRegistry registry = PlannerRegistry::standard();
  PlanQuery query;
  query.top = 1;
  for (int level = 1; level <= 4; ++level) {
    for (int i = 100; i < 200; ++i) {
      const Task task = testTask(level, i);
      const SymbolGraph graph = graphOf(task);
      for (const PlannerEntry& entry : registry.entries()) {
        const PlanResult result = registry.make(entry.name)->solve(graph, query);
        ASSERT_EQ(result.status, PlanStatus::kSolved)
            << entry.name << " " << task.id << ": " << result.reason;
        EXPECT_TRUE(judge(task, result.plans.front().actions).succeeded())
            << entry.name << " " << task.id;
      }
    }
  }
}

}  // namespace
}  // namespace conceptplan
