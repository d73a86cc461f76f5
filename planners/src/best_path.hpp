#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "conceptplan/planners/search_guard.hpp"
#include "radix_queue.hpp"
#include "successors.hpp"

namespace conceptplan {
namespace best_path {

/// A cost and, where costs are equal, a length, as one number.
using Label = std::uint64_t;

inline constexpr unsigned kLengthBits = 20;
inline constexpr std::size_t kLongest = (std::size_t{1} << kLengthBits) - 1;
inline constexpr PathCost kMostCost = (PathCost{1} << (64 - kLengthBits)) - 1;
inline constexpr Label kUnreached = std::numeric_limits<Label>::max();

inline Label labelOf(PathCost cost, std::size_t length) {
  return static_cast<Label>(cost) << kLengthBits | length;
}

inline PathCost costOf(Label label) { return static_cast<PathCost>(label >> kLengthBits); }

inline std::size_t lengthOf(Label label) { return label & kLongest; }

/// The best way found to a state.
struct Reached {
  Label label;
  std::uint32_t parent;
  bool closed;
};

/// States near each other share a page, which is made when the search first looks there. States
/// that are not valid begin with a label that no way betters.
template <typename Steps>
class ReachedStates {
 public:
  ReachedStates(std::size_t num_states, const Steps& steps)
      : num_states_(num_states), steps_(steps), pages_(num_states / kPageStates + 1) {}

  Reached& operator[](StateId state) {
    auto& page = pages_[index(state) / kPageStates];
    if (!page) page = newPage(index(state) / kPageStates * kPageStates);
    return (*page)[index(state) % kPageStates];
  }

 private:
  static constexpr std::size_t kPageStates = 64;
  using Page = std::array<Reached, kPageStates>;

  std::unique_ptr<Page> newPage(std::size_t first) const {
    auto page = std::make_unique_for_overwrite<Page>();
    const std::size_t states = std::min(kPageStates, num_states_ - first);
    for (std::size_t i = 0; i < states; ++i) {
      const bool valid = steps_.valid(static_cast<StateId>(first + i));
      (*page)[i] = {valid ? kUnreached : 0, 0, false};
    }
    return page;
  }

  std::size_t num_states_;
  const Steps& steps_;
  std::vector<std::unique_ptr<Page>> pages_;
};

template <typename Steps>
StatePath pathTo(StateId goal, ReachedStates<Steps>& reached, const Steps& steps) {
  StatePath path;
  path.cost = costOf(reached[goal].label);
  StateId state = goal;
  for (std::size_t i = lengthOf(reached[goal].label); i > 0; --i) {
    const auto before = static_cast<StateId>(reached[state].parent);
    const PathCost cost = costOf(reached[state].label) - costOf(reached[before].label);
    std::optional<Action> action;
    steps.forEach(before, [&](const Successor& step) {
      if (!action && step.state == state && step.cost == cost) action = step.action;
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
/// no path or a limit strikes. Each state where the search comes has a record of 16 bytes and is
/// expanded once.
///
/// Nothing if one label a state cannot tell: a state was as far from the start as the horizon
/// before the goal was found, so that a longer way to some state may have hidden a shorter one that
/// costs more; or costs or lengths grew beyond what a label holds.
///
/// A template, so that steps and heuristic are compiled into the loop.
/// @param steps `steps.forEach(state, visit)` calls `visit` with each step out of the state, also
/// those to states for which not `steps.valid(state)`.
/// @param heuristic the PathCost of a state.
/// @pre the heuristic is consistent.
template <typename Steps, typename Heuristic>
std::optional<std::vector<StatePath>> bestPath(std::size_t num_states, StateId start, StateId goal,
                                               const Steps& steps, const Heuristic& heuristic,
                                               std::size_t horizon, SearchGuard& guard,
                                               SearchStatistics& statistics) {
  using namespace best_path;
  const PathCost least = heuristic(start);
  if (least == kOutOfReach) return std::vector<StatePath>();
  if (least > kMostCost) return std::nullopt;
  ReachedStates reached(num_states, steps);
  RadixQueue<StateId> open;
  reached[start] = {labelOf(0, 0), static_cast<std::uint32_t>(start), false};
  open.push(labelOf(least, 0), start);
  bool fits = true;
  while (fits && !open.empty()) {
    const StateId state = open.pop();
    Reached& here = reached[state];
    if (here.closed) continue;
    here.closed = true;
    if (!guard.expand(statistics)) return std::vector<StatePath>();
    if (state == goal) return std::vector{pathTo(goal, reached, steps)};
    const PathCost cost = costOf(here.label);
    const std::size_t length = lengthOf(here.label) + 1;
    if (length > std::min(horizon, kLongest)) return std::nullopt;
    steps.forEach(state, [&](const Successor& step) {
      if (step.cost > kMostCost - cost) {
        fits = false;
        return;
      }
      const Label label = labelOf(cost + step.cost, length);
      Reached& there = reached[step.state];
      if (label >= there.label) return;
      const PathCost rest = heuristic(step.state);
      if (rest == kOutOfReach) return;
      if (rest > kMostCost - cost - step.cost) {
        fits = false;
        return;
      }
      ++statistics.generated;
      there = {label, static_cast<std::uint32_t>(state), false};
      open.push(labelOf(cost + step.cost + rest, length), step.state);
    });
  }
  if (!fits) return std::nullopt;
  return std::vector<StatePath>();
}

}  // namespace conceptplan
