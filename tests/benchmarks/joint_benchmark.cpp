// How planning for several targets together grows with their number and with the workbench.

#include <benchmark/benchmark.h>

#include "conceptplan/domain/simulation/second_target.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/planners/joint_planner.hpp"
#include "planners/joint_world.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan {
namespace {

PlanQuery bestOne() {
  PlanQuery query;
  query.top = 1;
  query.limits.max_expansions = 1'000'000;
  return query;
}

/// Plans for all worlds in each iteration; tells how many expansions a world takes.
void planAll(benchmark::State& state, const std::vector<testing::JointWorld>& worlds,
             const PlanQuery& query) {
  const JointPlanner planner;
  std::size_t expanded = 0;
  for (auto _ : state) {
    for (const testing::JointWorld& world : worlds) {
      const PlanResult result = planner.solve(world.model, world.problem, GridValidity(), query);
      expanded += result.statistics.expanded;
      if (result.status == PlanStatus::kLimit) state.SkipWithError(result.reason.c_str());
    }
  }
  const auto solved = state.iterations() * static_cast<std::int64_t>(worlds.size());
  state.counters["expanded"] = static_cast<double>(expanded) / static_cast<double>(solved);
  state.counters["problems"] = static_cast<double>(worlds.size());
  state.SetItemsProcessed(solved);
}

/// Drawn benches of range(0) x range(0) cells with four rotations, range(1) targets and a tenth of
/// the cells taken.
void drawnBenches(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  std::vector<testing::JointWorld> worlds;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    worlds.push_back(testing::drawnJointGrid(side, side, 4,
                                             static_cast<std::size_t>(state.range(1)),
                                             static_cast<std::size_t>(side * side / 10), seed));
  }
  planAll(state, worlds, bestOne());
}

/// Level-4 tasks of the test split with a second target, from learned tables; range(0) plans.
void learnedTasks(benchmark::State& state) {
  TaskOptions options;
  options.level = 4;
  options.split = Split::kTest;
  const TaskGenerator generator(options);
  std::vector<testing::JointWorld> worlds;
  for (int i = 0; i < 40; ++i) {
    RandomStream random{static_cast<std::uint64_t>(i)};
    const std::optional<Task> task = withSecondTarget(generator.task(i), random);
    if (task) worlds.push_back(testing::learnedJointWorld(*task));
  }
  PlanQuery query = bestOne();
  query.top = static_cast<std::size_t>(state.range(0));
  planAll(state, worlds, query);
}

BENCHMARK(drawnBenches)
    ->ArgNames({"side", "targets"})
    ->ArgsProduct({{4, 8, 16}, {1, 2, 3, 4}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(learnedTasks)->ArgName("top")->Arg(1)->Arg(5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace conceptplan
