#include "conceptplan/planners/best_first_planner.hpp"

#include <functional>

#include "conceptplan/planners/path_planning.hpp"
#include "option_range.hpp"
#include "path_search.hpp"
#include "projection_heuristic.hpp"

namespace conceptplan {
namespace {

/// Nothing if a limit struck.
std::optional<PathHeuristic> heuristicOf(Guidance guidance, const PathTask& task,
                                         const StateSteps& successors) {
  if (guidance == Guidance::kNone) return [](StateId) { return PathCost{0}; };
  if (guidance == Guidance::kProjections) {
    return ProjectionHeuristic(task.graph, task.goal, successors);
  }
  auto distances = distancesToGoal(task.graph.numStates(), task.start, task.goal,
                                   std::cref(successors), task.guard, task.statistics);
  if (!distances) return std::nullopt;
  return [distances = std::move(*distances)](StateId state) { return distances[index(state)]; };
}

}  // namespace

BestFirstPlanner::BestFirstPlanner(const BestFirstPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 0, 0.5);
}

PlanResult BestFirstPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  const StateSteps successors =
      likelySuccessors(graph, options_.legality_threshold, options_.step_discount);
  return planByPaths(graph, query, options_.legality_threshold,
                     [&](const PathTask& task) -> std::vector<StatePath> {
                       const auto heuristic = heuristicOf(options_.guidance, task, successors);
                       if (!heuristic) return {};
                       return bestPaths(graph.numStates(), task.start, task.goal,
                                        std::cref(successors), *heuristic,
                                        {query.top, query.limits.horizon, options_.greedy},
                                        task.guard, task.statistics);
                     });
}

}  // namespace conceptplan
