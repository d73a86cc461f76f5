#include "conceptplan/planners/mcts_planner.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "planners/grid_world.hpp"

namespace conceptplan {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

SymbolGraph bench() {
  const testing::GridWorld world = testing::gridWorld(6, 6, 4, 0, 1);
  return compile(world.model, world.problem, GridValidity());
}

MctsPlanner withIterations(std::size_t iterations) {
  MctsPlannerOptions options;
  options.iterations = iterations;
  return MctsPlanner(options);
}

TEST(MctsPlanner, WhereExpansionsRunOutTheRunsSoFarGiveThePlans) {
  const PlanQuery query;
  const PlanResult result = withIterations(20'001).solve(bench(), query);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans, SizeIs(query.top));
  EXPECT_EQ(result.reason, "stopped at the limit of 20000 expansions; the best plans found so far");
  EXPECT_LE(result.statistics.expanded, query.limits.max_expansions);
}

TEST(MctsPlanner, AFewRunsGiveAPlanToo) {
  PlanQuery query;
  query.limits.max_expansions = 300;  // half of them go into the distances
  const PlanResult result = withIterations(1000).solve(bench(), query);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.reason, HasSubstr("limit of 300 expansions"));
  EXPECT_LE(result.statistics.expanded, 300u);
}

TEST(MctsPlanner, GivesPlansAfterACancel) {
  std::atomic<bool> cancel{false};
  PlanQuery query;
  query.limits.timeout_s = 1000;
  query.limits.max_expansions = 1'000'000'000;
  query.limits.cancel = &cancel;
  const SymbolGraph graph = bench();
  auto answer = std::async(std::launch::async,
                           [&] { return withIterations(1'000'000'000).solve(graph, query); });
  std::this_thread::sleep_for(50ms);
  cancel = true;
  const PlanResult result = answer.get();
  EXPECT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_EQ(result.reason, "cancelled; the best plans found so far");
  EXPECT_THAT(result.plans, Not(IsEmpty()));
}

}  // namespace
}  // namespace conceptplan
