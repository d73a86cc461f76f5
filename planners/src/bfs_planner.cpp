#include "conceptplan/planners/bfs_planner.hpp"

#include "conceptplan/planners/path_planning.hpp"
#include "option_range.hpp"
#include "path_search.hpp"

namespace conceptplan {

BfsPlanner::BfsPlanner(const BfsPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
}

PlanResult BfsPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  const SuccessorFunction successors =
      likelySuccessors(graph, options_.legality_threshold, [](const Transition&) { return kNat; });
  return planByPaths(graph, query, options_.legality_threshold, [&](const PathTask& task) {
    // Equal ranks leave the queue in the order in which they came, so paths of one length are
    // expanded in the order of their actions.
    return bestPaths(
        graph.numStates(), task.start, task.goal, successors, [](StateId) { return PathCost{0}; },
        {query.top, query.limits.horizon}, task.guard, task.statistics);
  });
}

}  // namespace conceptplan
