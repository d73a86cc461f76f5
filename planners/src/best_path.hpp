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

/// A path of least cost, of these one of the fewest steps, and with the oldest of ties first and
/// costs that are not reduced that which `severalPaths` finds first; in a list of one, or an empty
/// list if there is no path or a limit strikes. Each state where the search comes has a record of
/// 12 bytes, each state of the problem half a byte, and each is expanded at most once.
///
/// Nothing if one record a state cannot tell: a state was as far from the start as the horizon
/// before the goal was found, so that a longer way to some state may have hidden a shorter one that
/// costs more; or a way grew beyond what a rank can tell.
///
/// A template, so that the steps are compiled into the loop.
/// @param least the rank at which the start is reached; the cost of the path is the rank at which
/// the goal is.
/// @param steps `steps.forEach(state, visit)` calls `visit` with each step out of the state, its
/// cost a PathRank that is not negative and at most 2 kFarthest, or anything if the step leads to a
/// state for which not `steps.valid(state)`.
template <typename Steps>
std::optional<std::vector<StatePath>> bestPath(std::size_t num_states, StateId start, StateId goal,
                                               PathRank least, const Steps& steps,
                                               std::size_t horizon, TieOrder ties,
                                               SearchGuard& guard, SearchStatistics& statistics) {
  struct Open {
    StateId state;
    std::uint32_t length;  // of the way to it
  };
  const std::size_t longest = std::min(horizon, kMostSteps);
  ReachedStates reached(num_states, steps);
  RadixQueue<Open> open(ties);
  reached[start].rank = least;
  open.push(static_cast<std::uint64_t>(least), {start, 0});
  while (!open.empty()) {
    const auto next = open.pop();
    const Open way = next.value;
    const auto rank = static_cast<PathRank>(next.key);
    if (rank != reached[way.state].rank) continue;  // a better one came by
    if (!guard.expand(statistics, way.state)) return std::vector<StatePath>();
    if (way.state == goal) return std::vector{reached.pathBetween(start, goal)};
    if (rank > kMostRank || way.length >= longest) return std::nullopt;
    steps.forEach(way.state, [&](const Successor& step) {
      const PathRank longer = rank + step.cost;
      const auto there = reached[step.state];
      if (longer >= there.rank) return;
      ++statistics.generated;
      there.rank = longer;
      there.parent = way.state;
      open.push(static_cast<std::uint64_t>(longer), {step.state, way.length + 1});
    });
  }
  return std::vector<StatePath>();
}

}  // namespace conceptplan
