#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>

namespace conceptplan {

/// A state of a SymbolGraph, in [0, numStates).
enum class StateId : std::int32_t {};

constexpr std::size_t index(StateId state) { return static_cast<std::size_t>(state); }

/// One possible next state.
struct Transition {
  StateId state{};
  double probability = 0;  ///< in (0, 1]
  double cost = 0;         ///< -log probability
};

/// One outcome of an action, in all states that agree in what it depends on.
struct Outcome {
  std::int32_t shift = 0;  ///< from the number of the state to that of the next one
  double probability = 0;  ///< in (0, 1]
  double cost = 0;         ///< -log probability

  StateId from(StateId state) const {
    return static_cast<StateId>(static_cast<std::int32_t>(state) + shift);
  }
};

/// The outcomes of an action in one state as a range of `Transition`; a view into the graph.
class TransitionRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Transition;
    using difference_type = std::ptrdiff_t;
    using pointer = const Transition*;
    using reference = Transition;

    Iterator(StateId state, const Outcome* outcome) : state_(state), outcome_(outcome) {}

    Transition operator*() const {
      return {outcome_->from(state_), outcome_->probability, outcome_->cost};
    }
    Iterator& operator++() {
      ++outcome_;
      return *this;
    }
    Iterator operator++(int) { return {state_, outcome_++}; }
    bool operator==(const Iterator&) const = default;

   private:
    StateId state_;
    const Outcome* outcome_;
  };

  TransitionRange(StateId state, std::span<const Outcome> outcomes)
      : state_(state), outcomes_(outcomes) {}

  Iterator begin() const { return {state_, outcomes_.data()}; }
  Iterator end() const { return {state_, outcomes_.data() + outcomes_.size()}; }
  std::size_t size() const { return outcomes_.size(); }
  bool empty() const { return outcomes_.empty(); }
  Transition operator[](std::size_t i) const { return *Iterator(state_, &outcomes_[i]); }
  Transition front() const { return *begin(); }

 private:
  StateId state_;
  std::span<const Outcome> outcomes_;
};

}  // namespace conceptplan
