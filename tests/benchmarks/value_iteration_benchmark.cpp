// Value iteration on a workbench of 200 x 200 cells with four rotations on which every action may
// slip: ours, and sweeps of one sparse matrix an action with Eigen. Both stop once no value changes
// by more than leaves an error of epsilon; the largest difference between the two results is among
// the counters.

#include <benchmark/benchmark.h>

#include <Eigen/SparseCore>

#include "benchmarks/one_plan.hpp"
#include "conceptplan/planners/value_iteration_planner.hpp"
#include "goal_mdp.hpp"
#include "path_search.hpp"
#include "planners/grid_world.hpp"
#include "planners/obstacle_map.hpp"
#include "value_iteration.hpp"

namespace conceptplan {
namespace {

constexpr int kSide = 200;
constexpr int kRotations = 4;
constexpr double kObstacleShare = 0.1;
constexpr double kSlip = 0.1;
constexpr ValueIterationPlannerOptions kOptions;

/// The model in which every action fails to change anything with that probability.
SymbolicModel slippery(const SymbolicModel& sure, double slip) {
  EffectTable effects;
  for (const Action action : kActions) {
    for (const Concept which : kConcepts) {
      Effect& effect = effects[index(action)][index(which)];
      effect = sure.transitions.effect(action, which);
      // Contexts are the own symbol, so a row's number is the symbol that stays.
      for (auto& [own, row] : effect.rows) {
        for (double& probability : row) probability *= 1 - slip;
        row[own] += slip;
      }
    }
  }
  return {sure.grounding, TransitionModel(sure.cardinality(), effects), sure.legality, {}};
}

SymbolGraph slipperyBench() {
  const testing::GridWorld world = testing::gridWorld(kSide, kSide, kRotations, 0, 1);
  return compile(slippery(world.model, kSlip), world.problem,
                 testing::ObstacleMap(kSide, kSide, kObstacleShare, 1));
}

const SymbolGraph& bench() {
  static const SymbolGraph graph = slipperyBench();
  return graph;
}

/// A change of all values that leaves an error of epsilon at most.
double lastChange() {
  return kOptions.epsilon * kOptions.step_discount / (1 - kOptions.step_discount);
}

/// Pr[next state | state, action] of what is legal and valid, one matrix an action.
class SparseSweeps {
 public:
  SparseSweeps() : goal_(static_cast<Eigen::Index>(index(bench().mostProbableGoal()))) {
    const auto states = static_cast<Eigen::Index>(bench().numStates());
    for (const Action action : kActions) {
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index i = 0; i < states; ++i) {
        const auto state = static_cast<StateId>(i);
        if (!bench().valid(state) || i == goal_ ||
            bench().legality(state, action) <= kOptions.legality_threshold) {
          continue;
        }
        for (const Transition& next : bench().transitions(state, action)) {
          if (!bench().valid(next.state)) continue;
          entries.emplace_back(i, static_cast<Eigen::Index>(index(next.state)), next.probability);
        }
      }
      if (entries.empty()) continue;
      matrices_.emplace_back(states, states).setFromTriplets(entries.begin(), entries.end());
    }
  }

  /// V(s) = max over a of discount * sum over s' of P_a(s, s') V(s'), 1 at the goal.
  Eigen::VectorXd solve(std::size_t& sweeps) const {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bench().numStates()));
    values[goal_] = 1;
    for (double change = 1; change > lastChange(); ++sweeps) {
      Eigen::VectorXd next = Eigen::VectorXd::Zero(values.size());
      for (const Matrix& matrix : matrices_) next = next.cwiseMax(matrix * values);
      next *= 1 - kOptions.step_discount;
      next[goal_] = 1;
      change = (next - values).lpNorm<Eigen::Infinity>();
      values.swap(next);
    }
    return values;
  }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  Eigen::Index goal_;
  std::vector<Matrix> matrices_;
};

/// The values of the states, and which of them the start leads to.
struct Values {
  std::vector<double> values;
  std::vector<PathCost> distances;
};

/// Distances to the goal, from which the values start and are ordered, and sweeps.
Values ourValues() {
  SearchGuard guard(testing::onePlan().limits);
  SearchStatistics statistics;
  const StateId goal = bench().mostProbableGoal();
  const auto distances = distancesToGoal(bench().numStates(), bench().mostProbableStart(), goal,
                                         anyOutcomeSuccessors(bench(), kOptions.legality_threshold),
                                         guard, statistics);
  const GoalMdp mdp(bench(), goal, kOptions.legality_threshold, kOptions.step_discount, *distances);
  return {*valueIteration(mdp, kOptions.epsilon, guard, statistics), *distances};
}

/// The sweeps alone; the matrices are made before.
void sparseMatrixSweeps(benchmark::State& state) {
  const SparseSweeps mdp;
  std::size_t sweeps = 0;
  for (auto _ : state) benchmark::DoNotOptimize(mdp.solve(sweeps));
  state.counters["sweeps"] = static_cast<double>(sweeps) / static_cast<double>(state.iterations());
}

void ourValueIteration(benchmark::State& state) {
  Values ours;
  for (auto _ : state) ours = ourValues();
  std::size_t sweeps = 0;
  const Eigen::VectorXd other = SparseSweeps().solve(sweeps);
  double difference = 0;
  for (std::size_t i = 0; i < ours.values.size(); ++i) {
    if (ours.distances[i] == kOutOfReach) continue;
    difference =
        std::max(difference, std::abs(ours.values[i] - other[static_cast<Eigen::Index>(i)]));
  }
  state.counters["difference"] = difference;
  state.counters["states"] = static_cast<double>(ours.values.size());
}

/// The whole planner: distances, sweeps, the best plan and its trace.
void ourValueIterationPlanner(benchmark::State& state) {
  const ValueIterationPlanner planner(kOptions);
  for (auto _ : state) {
    const PlanResult result = planner.solve(bench(), testing::onePlan());
    if (!testing::isSolved(result, state)) break;
  }
}

BENCHMARK(ourValueIteration)->Unit(benchmark::kMillisecond);
BENCHMARK(ourValueIterationPlanner)->Unit(benchmark::kMillisecond);
BENCHMARK(sparseMatrixSweeps)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace conceptplan
