#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "conceptplan/planners/search_guard.hpp"
#include "path_rank.hpp"
#include "radix_queue.hpp"
#include "reached_states.hpp"
#include "successors.hpp"

namespace conceptplan {

/// A best path as `severalPaths` orders paths, with the oldest of ties first the first of its, in a
/// list of one; or an empty list if there is no path or a limit strikes. Each state where the
/// search comes has a record of 12 bytes, each state of the problem half a byte, and each is
/// expanded at most once.
///
/// Nothing if one record a state cannot tell: a state was as far from the start as the horizon
/// before the goal was found, so that a longer way to some state may have hidden a shorter one that
/// costs more; or a way grew beyond what a rank can tell.
///
/// A template, so that steps and heuristic are compiled into the loop.
/// @param steps `steps.forEach(state, visit)` calls `visit` with each step out of the state, its
/// cost a PathRank; also those to states for which not `steps.valid(state)`.
/// @param heuristic a lower bound of the PathRank from a state to the goal, at most kFarthest;
/// kOutOfReach where there is no way.
/// @pre the heuristic is consistent.
template <typename Steps, typename Heuristic>
std::optional<std::vector<StatePath>> bestPath(std::size_t num_states, StateId start, StateId goal,
                                               const Steps& steps, const Heuristic& heuristic,
                                               std::size_t horizon, TieOrder ties,
                                               SearchGuard& guard, SearchStatistics& statistics) {
  const PathRank least = heuristic(start);
  if (least == kOutOfReach) return std::vector<StatePath>();
  const std::size_t longest = std::min(horizon, kMostSteps);
  ReachedStates reached(num_states, steps);
  struct OpenWay {
    PathRank rank;
    StateId state;
  };
  RadixQueue<OpenWay> open(ties);
  reached[start].rank = 0;
  open.push(static_cast<std::uint64_t>(least), {0, start});
  while (!open.empty()) {
    const OpenWay way = open.pop();
    if (way.rank != reached[way.state].rank) continue;  // a better one came by
    if (!guard.expand(statistics)) return std::vector<StatePath>();
    if (way.state == goal) return std::vector{reached.pathTo(goal)};
    if (way.rank > kMostRank || stepsOf(way.rank) >= longest) return std::nullopt;
    steps.forEach(way.state, [&](const Successor& step) {
      const PathRank rank = way.rank + step.cost;
      const auto there = reached[step.state];
      if (rank >= there.rank) return;
      const PathRank rest = heuristic(step.state);
      if (rest == kOutOfReach) return;
      ++statistics.generated;
      there.rank = rank;
      there.parent = way.state;
      open.push(static_cast<std::uint64_t>(rank + rest), {rank, step.state});
    });
  }
  return std::vector<StatePath>();
}

}  // namespace conceptplan
