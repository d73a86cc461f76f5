#pragma once

#include <functional>
#include <vector>

#include "conceptplan/planners/planner.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "conceptplan/planners/state_path.hpp"

namespace conceptplan {

/// What a planner over single states is asked for: paths between the most probable symbols.
struct PathTask {
  const SymbolGraph& graph;
  const PlanQuery& query;
  StateId start;
  StateId goal;
  SearchGuard& guard;  ///< to be asked before each expansion
  SearchStatistics& statistics;
};

/// Gives paths from start to goal, distinct and best first, at most `query.top` of at most
/// `query.limits.horizon` actions. None means that it is proved that there are none, unless the
/// guard has been stopped.
using PathFinder = std::function<std::vector<StatePath>(const PathTask&)>;

/// The answer of a planner that commits itself to the most probable symbols of start, goal and the
/// other objects: what `Planner::search` of such a planner returns. All share this: they refuse a
/// task in which a concept that nothing changes would have to change; they give up, and prove
/// nothing, where a plan may lead over states whose validity check failed; a plan's probability is
/// that of the whole belief (`probabilityOf`, joint), its cost that of its path; a failure has its
/// reason and rejections.
/// @param legality_threshold an action is legal where Pr[a | Omega] is greater
PlanResult planByPaths(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                       const PathFinder& paths);

}  // namespace conceptplan
