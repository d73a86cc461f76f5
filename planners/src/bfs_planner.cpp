#include "conceptplan/planners/bfs_planner.hpp"

#include "conceptplan/planners/path_planning.hpp"
#include "option_range.hpp"
#include "path_search.hpp"

namespace conceptplan {

BfsPlanner::BfsPlanner(const BfsPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
}

PlanResult BfsPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPaths(graph, query, options_.legality_threshold, [&](const PathTask& task) {
    return shortestPaths(graph, options_.legality_threshold, task.start, task.goal,
                         {query.top, query.limits.horizon}, task.guard, task.statistics);
  });
}

}  // namespace conceptplan
