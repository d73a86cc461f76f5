#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "compiled_action.hpp"
#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// What a SymbolGraph consists of but for its task.
struct GraphTables {
  /// One way to read the other objects. Actions that do not depend on them are shared.
  struct Reading {
    double share = 0;
    std::array<std::shared_ptr<const CompiledAction>, kNumActions> actions;
    std::vector<Verdict> verdicts;  ///< [checked]
  };

  Symbols fixed{};  ///< of the target; those of concepts that are part of the states mean nothing
  ConceptCardinality cardinality{};
  std::array<Mutability, kNumConcepts> mutability{};
  SymbolIndex states;   ///< of one reading
  SymbolIndex checked;  ///< validity depends on these
  std::vector<Reading> readings;
  std::vector<std::uint8_t> valid;  ///< [states of all readings], 1 or 0

  std::size_t readingOf(StateId state) const {
    return readings.size() == 1 ? 0 : index(state) / states.size();
  }
  /// The number of a state among those of its reading.
  std::size_t numberInReading(StateId state) const {
    return index(state) - readingOf(state) * states.size();
  }
  Symbols symbols(StateId state) const { return states.symbols(numberInReading(state), fixed); }
};

/// What actions do in one state, whose symbols are read once.
class StateActions {
 public:
  StateActions(const SymbolGraph& graph, StateId state)
      : state_(state),
        symbols_(graph.tables().symbols(state)),
        actions_(graph.tables().readings[graph.tables().readingOf(state)].actions) {}

  double legality(Action action) const { return actions_[index(action)]->legality(symbols_); }
  TransitionRange transitions(Action action) const {
    return {state_, actions_[index(action)]->outcomes(symbols_)};
  }

 private:
  StateId state_;
  Symbols symbols_;
  const std::array<std::shared_ptr<const CompiledAction>, kNumActions>& actions_;
};

}  // namespace conceptplan
