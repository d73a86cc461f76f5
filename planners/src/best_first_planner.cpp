#include "conceptplan/planners/best_first_planner.hpp"

#include <functional>

#include "conceptplan/planners/path_planning.hpp"
#include "option_range.hpp"
#include "path_search.hpp"
#include "projection_heuristic.hpp"

namespace conceptplan {

BestFirstPlanner::BestFirstPlanner(const BestFirstPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 0, 0.5);
}

PlanResult BestFirstPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPaths(graph, query, options_.legality_threshold, [&](const PathTask& task) {
    const StateSteps successors =
        rankedSuccessors(graph, options_.legality_threshold, options_.step_discount, &task.guard);
    const auto paths = [&](const auto& heuristic) {
      return bestPaths(graph.numStates(), task.start, task.goal, successors, heuristic,
                       {query.top, query.limits.horizon, options_.greedy}, task.guard,
                       task.statistics);
    };
    if (options_.guidance == Guidance::kNone) return paths([](StateId) { return PathRank{0}; });
    if (options_.guidance == Guidance::kProjections) {
      return paths(ProjectionHeuristic(graph, task.goal, successors, &task.guard));
    }
    const auto distances = distancesToGoal(graph.numStates(), task.start, task.goal,
                                           std::cref(successors), task.guard, task.statistics);
    if (!distances) return std::vector<StatePath>();
    return paths([&](StateId state) { return (*distances)[index(state)]; });
  });
}

}  // namespace conceptplan
