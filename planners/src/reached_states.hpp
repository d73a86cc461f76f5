#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "path_rank.hpp"
#include "successors.hpp"

namespace conceptplan {

/// The best way found to each state of a search. States near each other share a page, which is made
/// when the search first looks there. States that are not valid begin with a rank that no way
/// betters.
template <typename Steps>
class ReachedStates {
 public:
  /// The best way found to a state.
  struct Reached {
    PathRank& rank;
    StateId& parent;  ///< no meaning where no way has been found
  };

  /// @param steps as for `bestPath`; a reference is kept.
  ReachedStates(std::size_t num_states, const Steps& steps)
      : num_states_(num_states), steps_(steps), pages_(num_states / kPageStates + 1, nullptr) {}

  Reached operator[](StateId state) {
    const std::size_t number = index(state);
    Page*& page = pages_[number / kPageStates];
    if (page == nullptr) [[unlikely]]
      page = newPage(number - number % kPageStates);
    return {page->ranks[number % kPageStates], page->parents[number % kPageStates]};
  }

  /// The way found to a state that has one, its cost the rank at which the state is reached.
  StatePath pathBetween(StateId start, StateId end) {
    StatePath path;
    path.cost = costOf((*this)[end].rank);
    for (StateId state = end; state != start;) {
      const StateId before = (*this)[state].parent;
      const PathRank rank = (*this)[state].rank - (*this)[before].rank;
      std::optional<Action> action;
      steps_.forEach(before, [&](const Successor& step) {
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

 private:
  // A search looks at few of the states near each other in number, so pages are small.
  static constexpr std::size_t kPageStates = 16;
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
      // The greatest number or, one more, the least; a branch would often be mispredicted.
      page.ranks[i] = static_cast<PathRank>(std::uint64_t{kOutOfReach} + (is_valid ? 0 : 1));
    }
    return &page;
  }

  std::size_t num_states_;
  const Steps& steps_;
  std::vector<Page*> pages_;  // [states / kPageStates], null where the search has not been
  std::vector<std::unique_ptr<Page[]>> chunks_;
  std::size_t num_pages_ = 0;  // in the chunks
};

}  // namespace conceptplan
