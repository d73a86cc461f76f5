#pragma once

#include "blocking_objects.hpp"
#include "conceptplan/planners/graph_source.hpp"
#include "conceptplan/planners/search_guard.hpp"

namespace conceptplan {

/// The fewest objects without which legal actions, by any outcomes, lead from the most probable
/// start to the most probable goal, however many it takes; `BlockingObjects` tells how many. The
/// problem without them has been compiled and searched.
///
/// Ends as unknown where a limit strikes, or once 10 million states have been looked at or
/// compiled.
/// @param source of the graph
/// @param statistics gets the validity checks
BlockingObjects blockingObjects(const SymbolGraph& graph, const GraphSource& source,
                                double legality_threshold, SearchGuard& guard,
                                SearchStatistics& statistics);

}  // namespace conceptplan
