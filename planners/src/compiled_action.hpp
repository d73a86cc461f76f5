#pragma once

#include <span>
#include <vector>

#include "conceptplan/planners/transition.hpp"
#include "model_tables.hpp"

namespace conceptplan {

/// One action among certain other objects, for the states of a graph. States that agree in what
/// the action depends on share their outcomes, so its size does not grow with the other concepts.
class CompiledAction {
 public:
  /// @param states the number of a state's symbols
  /// @param fixed the target's symbols of the concepts that are not part of the states
  /// @param guard once it has been stopped, the action has no use
  CompiledAction(const ActionTables& tables, const SymbolIndex& states,
                 const ConceptCardinality& cardinality, const Symbols& fixed, SearchGuard& guard);

  /// Pr[a | Omega]; 0 where the action has no effect that is defined.
  double legality(const Symbols& target) const { return legality_[target]; }

  /// By falling probability, ties by state; they sum to one.
  std::span<const Outcome> outcomes(const Symbols& target) const {
    const Range range = ranges_[target];
    return std::span(outcomes_).subspan(range.first, range.count);
  }

  /// What legality and outcomes depend on.
  const SymbolIndex& contexts() const { return contexts_; }

 private:
  struct Range {
    std::uint32_t first;
    std::uint32_t count;
  };

  SymbolIndex contexts_;
  SymbolTable<double> legality_;
  SymbolTable<Range> ranges_;
  std::vector<Outcome> outcomes_;
};

}  // namespace conceptplan
