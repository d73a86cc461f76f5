#include "conceptplan/planners/path_planning.hpp"

#include <string>

#include "legality_trace.hpp"
#include "sparse_belief.hpp"

namespace conceptplan {
namespace {

/// States around the start whose rejections are told of when there is no plan.
constexpr std::size_t kTracedStates = 64;

PlanResult answer(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                  const PathFinder& paths, SearchGuard& guard) {
  PlanResult result;
  const PathTask task{
      graph, query, graph.mostProbableStart(), graph.mostProbableGoal(), guard, result.statistics};
  const bool is_possible = frozenMismatch(graph).empty();
  const std::vector<StatePath> found = is_possible ? paths(task) : std::vector<StatePath>();
  if (found.empty()) {
    if (!guard.stopped() && is_possible) {
      giveUpIfUnchecked(graph, task.start, task.goal, legality_threshold, query.limits.horizon,
                        guard);
    }
    result.status = guard.stopped().value_or(PlanStatus::kInfeasible);
    if (guard.stopped()) {
      result.reason = guard.reason();
    } else {
      explainInfeasible(graph, query, legality_threshold, guard, result);
    }
    result.rejections = traceRejections(
        graph,
        reachableStates(graph, task.start, legality_threshold, query.limits.horizon, kTracedStates),
        legality_threshold);
    return result;
  }
  const SparseBelief start = sparseStartBelief(graph, graph.initialBelief());
  const SparseBelief goal = sparseStateBelief(graph, graph.problem().goal);
  for (const StatePath& path : found) {
    Plan plan;
    plan.actions = path.actions;
    plan.cost = toNats(path.cost);
    plan.probability = probabilityOf(graph, path.actions, start, goal, legality_threshold).joint;
    for (const StateId state : path.states) plan.predicted.push_back(graph.symbols(state));
    result.plans.push_back(std::move(plan));
  }
  result.status = PlanStatus::kSolved;
  if (guard.stopped()) result.reason = guard.reason() + "; the best plans found so far";
  std::vector<StateId> along{task.start};
  along.insert(along.end(), found.front().states.begin(), found.front().states.end());
  result.rejections = traceRejections(graph, along, legality_threshold);
  return result;
}

}  // namespace

PlanResult planByPaths(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                       const PathFinder& paths) {
  return withTally(graph, query, legality_threshold, [&](SearchGuard& guard) {
    return answer(graph, query, legality_threshold, paths, guard);
  });
}

}  // namespace conceptplan
