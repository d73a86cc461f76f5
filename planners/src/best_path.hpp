#pragma once

#include <optional>
#include <vector>

#include "path_search.hpp"

namespace conceptplan {

/// The one best path as `bestPaths` orders paths, in a list of one, or an empty list if there is no
/// path or a limit strikes. Each state where the search comes has one label of 12 bytes and is
/// expanded once.
///
/// Nothing if one label a state cannot tell: a state was as far from the start as the horizon
/// before the goal was found, so that a longer way to some state may have hidden a shorter one that
/// costs more; or costs or lengths grew beyond what a label holds.
/// @pre the heuristic is consistent.
std::optional<std::vector<StatePath>> bestPath(std::size_t num_states, StateId start, StateId goal,
                                               const SuccessorFunction& successors,
                                               const PathHeuristic& heuristic, std::size_t horizon,
                                               SearchGuard& guard, SearchStatistics& statistics);

}  // namespace conceptplan
