// Level-4 scenarios a second, and how compiling and searching grow with the workbench, the values
// of a concept, the obstacles and the number of plans.

#include <benchmark/benchmark.h>

#include "benchmarks/counted_memory.hpp"
#include "benchmarks/one_plan.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "planners/grid_world.hpp"
#include "planners/learned_world.hpp"
#include "planners/obstacle_map.hpp"

namespace conceptplan {
namespace {

constexpr int kScenarios = 200;

/// Level-4 tasks of the test split, as symbols.
const std::vector<SymbolicProblem>& levelFourProblems() {
  static const std::vector<SymbolicProblem> problems = [] {
    TaskOptions options;
    options.level = 4;
    options.split = Split::kTest;
    const TaskGenerator generator(options);
    std::vector<SymbolicProblem> drawn;
    for (int i = 0; i < kScenarios; ++i) {
      drawn.push_back(testing::learnedRelabelling().problem(generator.task(i)));
    }
    return drawn;
  }();
  return problems;
}

/// All of them in each iteration.
template <typename Solve>
void eachLevelFour(benchmark::State& state, Solve solve) {
  const SymbolicModel& model = testing::learnedModel();
  const auto& problems = levelFourProblems();
  for (auto _ : state)
    for (const SymbolicProblem& problem : problems) solve(model, problem);
  state.counters["problems"] = static_cast<double>(problems.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(problems.size()));
}

/// Compiles level-4 scenarios.
void compileLevelFour(benchmark::State& state, const StateValidity& validity) {
  eachLevelFour(state, [&](const SymbolicModel& model, const SymbolicProblem& problem) {
    benchmark::DoNotOptimize(compile(model, problem, validity));
  });
}

/// Compiles level-4 scenarios with FCL and finds their best plans.
void solveLevelFour(benchmark::State& state, const char* name) {
  const auto planner = PlannerRegistry::standard().make(name);
  const FclValidity validity;
  PlanQuery query;
  query.top = static_cast<std::size_t>(state.range(0));
  eachLevelFour(state, [&](const SymbolicModel& model, const SymbolicProblem& problem) {
    const PlanResult result = planner->solve(compile(model, problem, validity), query);
    testing::isSolved(result, state);
  });
}

/// A workbench, obstacles that are no objects, and what is done with it.
struct Bench {
  Bench(int side, int rotations)
      : world(testing::gridWorld(side, side, rotations, 0, 1)), obstacles(side, side, 0.1, 1) {}

  SymbolGraph compiled() const { return compile(world.model, world.problem, obstacles); }

  testing::GridWorld world;
  testing::ObstacleMap obstacles;
};

void compileBench(benchmark::State& state, const Bench& bench) {
  double peak_MB = 0;
  std::size_t states = 0;
  for (auto _ : state) {
    const testing::CountedMemory memory;
    states = bench.compiled().numStates();
    peak_MB = memory.peak_MB();
  }
  state.counters["states"] = static_cast<double>(states);
  state.counters["peak_MB"] = peak_MB;
}

void searchBench(benchmark::State& state, const Bench& bench, const char* name) {
  const SymbolGraph graph = bench.compiled();
  const auto planner = PlannerRegistry::standard().make(name);
  std::size_t expanded = 0;
  double peak_MB = 0;
  for (auto _ : state) {
    const testing::CountedMemory memory;
    const PlanResult result = planner->solve(graph, testing::onePlan());
    if (!testing::isSolved(result, state)) break;
    expanded += result.statistics.expanded;
    peak_MB = memory.peak_MB();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(expanded));
  state.counters["states"] = static_cast<double>(graph.numStates());
  state.counters["peak_MB"] = peak_MB;
}

constexpr int kRotations = 4;
constexpr int kSide = 50;

/// From one corner of n x n cells with four rotations to the other one.
void compileBySide(benchmark::State& state) {
  compileBench(state, {static_cast<int>(state.range(0)), kRotations});
}
void searchBySide(benchmark::State& state, const char* name) {
  searchBench(state, {static_cast<int>(state.range(0)), kRotations}, name);
}

/// 50 x 50 cells with n rotations.
void compileByValues(benchmark::State& state) {
  compileBench(state, {kSide, static_cast<int>(state.range(0))});
}
void searchByValues(benchmark::State& state, const char* name) {
  searchBench(state, {kSide, static_cast<int>(state.range(0))}, name);
}

/// The first n of the objects drawn on 50 x 50 cells.
SymbolicProblem withObstacles(const testing::GridWorld& world, std::size_t obstacles) {
  SymbolicProblem problem = world.problem;
  problem.initial.objects.resize(1 + obstacles);
  return problem;
}

template <typename Validity>
void compileByObstacles(benchmark::State& state) {
  const testing::GridWorld world = testing::gridWorld(kSide, kSide, kRotations, 0.25, 1);
  const SymbolicProblem problem = withObstacles(world, static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(compile(world.model, problem, Validity()));
}

void astarByObstacles(benchmark::State& state) {
  const testing::GridWorld world = testing::gridWorld(kSide, kSide, kRotations, 0.25, 1);
  const SymbolicProblem problem = withObstacles(world, static_cast<std::size_t>(state.range(0)));
  const SymbolGraph graph = compile(world.model, problem, GridValidity());
  const auto planner = PlannerRegistry::standard().make("astar");
  for (auto _ : state) {
    const PlanResult result = planner->solve(graph, testing::onePlan());
    if (!testing::isSolved(result, state)) break;
  }
}

BENCHMARK_CAPTURE(compileLevelFour, grid, GridValidity());
BENCHMARK_CAPTURE(compileLevelFour, fcl, FclValidity());
BENCHMARK_CAPTURE(solveLevelFour, kbest, "kbest")->Arg(1)->Arg(5)->Arg(25)->Arg(100)->Arg(400);
BENCHMARK_CAPTURE(solveLevelFour, astar, "astar")->Arg(1)->Arg(5)->Arg(25)->Arg(100)->Arg(400);
BENCHMARK_CAPTURE(solveLevelFour, dijkstra, "dijkstra")->Arg(5);
BENCHMARK_CAPTURE(solveLevelFour, belief, "belief")->Arg(5);

void sides(benchmark::internal::Benchmark* benchmark) {
  for (const int side : {10, 30, 100, 300}) benchmark->Arg(side);
  benchmark->Unit(benchmark::kMillisecond);
}
BENCHMARK(compileBySide)->Apply(sides)->Arg(1000);
BENCHMARK_CAPTURE(searchBySide, astar, "astar")->Apply(sides)->Arg(1000);
BENCHMARK_CAPTURE(searchBySide, dijkstra, "dijkstra")->Apply(sides);
BENCHMARK_CAPTURE(searchBySide, kbest, "kbest")->Apply(sides);
BENCHMARK_CAPTURE(searchBySide, value_iteration, "value-iteration")->Apply(sides);

void values(benchmark::internal::Benchmark* benchmark) {
  for (const int symbols : {2, 8, 32, 128, 512}) benchmark->Arg(symbols);
  benchmark->Unit(benchmark::kMillisecond);
}
BENCHMARK(compileByValues)->Apply(values);
BENCHMARK_CAPTURE(searchByValues, astar, "astar")->Apply(values);
BENCHMARK_CAPTURE(searchByValues, dijkstra, "dijkstra")->Apply(values);

void obstacles(benchmark::internal::Benchmark* benchmark) {
  for (const int objects : {1, 4, 16, 64, 256, 512}) benchmark->Arg(objects);
  benchmark->Unit(benchmark::kMillisecond);
}
BENCHMARK_TEMPLATE(compileByObstacles, GridValidity)->Apply(obstacles);
BENCHMARK_TEMPLATE(compileByObstacles, FclValidity)->Apply(obstacles);
BENCHMARK(astarByObstacles)->Apply(obstacles);

}  // namespace
}  // namespace conceptplan
