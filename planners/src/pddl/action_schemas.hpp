#pragma once

#include <string>
#include <vector>

#include "conceptplan/planners/pddl/determinisation.hpp"
#include "minimal_table.hpp"

namespace conceptplan {

/// The states in which a plan may be: the valid ones of reading 0, and the start.
struct PossibleStates {
  std::vector<StateId> states;
  std::vector<Symbols> symbols;  ///< of each

  explicit PossibleStates(const SymbolGraph& graph);

  /// Those where the action is legal.
  PossibleStates where(const SymbolGraph& graph, Action action, double legality_threshold) const;

 private:
  PossibleStates() = default;
};

/// One action of the problem with most probable outcomes.
struct ActionSchema {
  Action action{};
  std::vector<Concept> changes;     ///< what it changes, in some possible state where it is legal
  std::vector<MinimalTable> leads;  ///< next symbol of each of these
  MinimalTable legal;               ///< 1 or 0, over the possible states
  MinimalTable cost;                ///< whole cost, where it is legal
  bool may_be_invalid = false;      ///< its outcome need not be valid
  std::vector<Concept> parameters;  ///< concepts whose symbols it names, in the order of kConcepts
};

/// The actions of a graph, apart from those that change nothing.
struct ActionSchemas {
  MinimalTable valid;  ///< 1 or 0, over all states of reading 0
  std::vector<ActionSchema> actions;

  ActionSchemas(const SymbolGraph& graph, const Determinisation& determinisation);

  /// What the action names where it leads from one state to another: for each parameter the symbol
  /// before, and for those that it changes the symbol after. Empty for an action without a schema.
  std::vector<std::string> arguments(Action action, const Symbols& before,
                                     const Symbols& after) const;
};

/// The concepts that are part of the states.
std::vector<Concept> changingConcepts(const SymbolGraph& graph);

/// Number of symbols of each concept.
ConceptCardinality cardinalityOf(const SymbolGraph& graph);

/// 1 where states of reading 0 are valid, else 0; the start too, if wanted.
MinimalTable validTable(const SymbolGraph& graph, bool start_is_valid);

/// 1 where the action is legal, else 0.
MinimalTable legalTable(const SymbolGraph& graph, const PossibleStates& states, Action action,
                        double legality_threshold);

}  // namespace conceptplan
