// Scenarios a second, and how compiling and searching grow with the workbench.

#include <benchmark/benchmark.h>

#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "planners/grid_world.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan {
namespace {

/// Level-4 tasks of the test split, as symbols.
std::vector<SymbolicProblem> levelFourProblems() {
  TaskOptions options;
  options.level = 4;
  options.split = Split::kTest;
  const TaskGenerator generator(options);
  std::vector<SymbolicProblem> problems;
  for (int i = 0; i < 100; ++i) {
    problems.push_back(testing::learnedRelabelling().problem(generator.task(i)));
  }
  return problems;
}

/// Compiles a level-4 scenario.
void compileLevelFour(benchmark::State& state) {
  const std::vector<SymbolicProblem> problems = levelFourProblems();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        compile(testing::learnedModel(), problems[i++ % problems.size()], GridValidity()));
  }
  state.SetItemsProcessed(state.iterations());
}

/// Compiles a level-4 scenario and finds its five best plans.
void topFiveOfLevelFour(benchmark::State& state, const char* name) {
  const std::vector<SymbolicProblem> problems = levelFourProblems();
  const auto planner = PlannerRegistry::standard().make(name);
  std::size_t i = 0;
  for (auto _ : state) {
    const SymbolGraph graph =
        compile(testing::learnedModel(), problems[i++ % problems.size()], GridValidity());
    benchmark::DoNotOptimize(planner->solve(graph, {}));
  }
  state.SetItemsProcessed(state.iterations());
}

/// A bench of n x n cells with four rotations and a tenth of the cells taken.
testing::GridWorld square(const benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  return testing::gridWorld(side, side, 4, 0.1, 1);
}

void compileSquare(benchmark::State& state) {
  const testing::GridWorld world = square(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(compile(world.model, world.problem, GridValidity()));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(0) * 4);
}

/// Items are expansions.
void searchSquare(benchmark::State& state, const char* name) {
  const testing::GridWorld world = square(state);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  const auto planner = PlannerRegistry::standard().make(name);
  PlanQuery query;
  query.top = 1;
  query.limits.horizon = 10'000;
  query.limits.max_expansions = 100'000'000;
  std::size_t expanded = 0;
  for (auto _ : state) {
    const PlanResult result = planner->solve(graph, query);
    if (result.status != PlanStatus::kSolved) state.SkipWithError(result.reason.c_str());
    expanded += result.statistics.expanded;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(expanded));
}

BENCHMARK(compileLevelFour);
BENCHMARK_CAPTURE(topFiveOfLevelFour, kbest, "kbest");
BENCHMARK_CAPTURE(topFiveOfLevelFour, dijkstra, "dijkstra");
BENCHMARK_CAPTURE(topFiveOfLevelFour, astar, "astar");
BENCHMARK_CAPTURE(topFiveOfLevelFour, belief, "belief");
BENCHMARK(compileSquare)->Arg(10)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(searchSquare, dijkstra, "dijkstra")
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(searchSquare, astar, "astar")
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace conceptplan
