#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "conceptplan/planners/search_guard.hpp"
#include "path_rank.hpp"
#include "radix_queue.hpp"
#include "successors.hpp"

namespace conceptplan {
namespace best_path {

/// States near each other share a page, which is made when the search first looks there. States
/// that are not valid begin with a rank that no way betters.
template <typename Steps>
class ReachedStates {
 public:
  /// The best way found to a state.
  struct Reached {
    PathRank& rank;
    StateId& parent;  ///< no meaning where no way has been found
  };

  ReachedStates(std::size_t num_states, const Steps& steps)
      : num_states_(num_states), steps_(steps), pages_(num_states / kPageStates + 1, nullptr) {}

  Reached operator[](StateId state) {
    const std::size_t number = index(state);
    Page*& page = pages_[number / kPageStates];
    if (page == nullptr) [[unlikely]]
      page = newPage(number - number % kPageStates);
    return {page->ranks[number % kPageStates], page->parents[number % kPageStates]};
  }

 private:
  static constexpr std::size_t kPageStates = 64;
  static constexpr std::size_t kChunkPages = 32;

  struct Page {
    std::array<PathRank, kPageStates> ranks;
    std::array<StateId, kPageStates> parents;
  };

  /// Kept out of the loop that asks for it.
  [[gnu::noinline]] Page* newPage(std::size_t first_state) {
    if (num_pages_ % kChunkPages == 0) {
      chunks_.push_back(std::make_unique_for_overwrite<Page[]>(kChunkPages));
    }
    Page& page = chunks_.back()[num_pages_++ % kChunkPages];
    const std::size_t states = std::min(kPageStates, num_states_ - first_state);
    for (std::size_t i = 0; i < states; ++i) {
      const bool is_valid = steps_.valid(static_cast<StateId>(first_state + i));
      page.ranks[i] = -PathRank{is_valid} & kOutOfReach;  // a branch would often be mispredicted
    }
    return &page;
  }

  std::size_t num_states_;
  const Steps& steps_;
  std::vector<Page*> pages_;  // [states / kPageStates], null where the search has not been
  std::vector<std::unique_ptr<Page[]>> chunks_;
  std::size_t num_pages_ = 0;  // in the chunks
};

/// A way that waits to be continued.
struct OpenWay {
  PathRank rank;
  StateId state;
};

template <typename Steps>
StatePath pathTo(StateId goal, ReachedStates<Steps>& reached, const Steps& steps) {
  StatePath path;
  path.cost = costOf(reached[goal].rank);
  StateId state = goal;
  for (std::size_t i = stepsOf(reached[goal].rank); i > 0; --i) {
    const StateId before = reached[state].parent;
    const PathRank rank = reached[state].rank - reached[before].rank;
    std::optional<Action> action;
    steps.forEach(before, [&](const Successor& step) {
      if (!action && step.state == state && step.cost == rank) action = step.action;
    });
    path.actions.push_back(action.value());
    path.states.push_back(state);
    state = before;
  }
  std::reverse(path.actions.begin(), path.actions.end());
  std::reverse(path.states.begin(), path.states.end());
  return path;
}

}  // namespace best_path

/// The one best path as `severalPaths` orders paths, in a list of one, or an empty list if there is
/// no path or a limit strikes. Each state where the search comes has a record of 12 bytes and is
/// expanded once.
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
                                               std::size_t horizon, SearchGuard& guard,
                                               SearchStatistics& statistics) {
  const PathRank least = heuristic(start);
  if (least == kOutOfReach) return std::vector<StatePath>();
  const std::size_t longest = std::min(horizon, kMostSteps);
  best_path::ReachedStates reached(num_states, steps);
  RadixQueue<best_path::OpenWay> open;
  reached[start].rank = 0;
  open.push(static_cast<std::uint64_t>(least), {0, start});
  while (!open.empty()) {
    const best_path::OpenWay way = open.pop();
    if (way.rank != reached[way.state].rank) continue;  // a better one came by
    if (!guard.expand(statistics)) return std::vector<StatePath>();
    if (way.state == goal) return std::vector{pathTo(goal, reached, steps)};
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
