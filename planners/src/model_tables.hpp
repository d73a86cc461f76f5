#pragma once

#include <array>
#include <vector>

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "symbol_table.hpp"

namespace conceptplan {

/// One possible next symbol of a concept.
struct SymbolOutcome {
  std::size_t symbol;
  double probability;
};

/// The next symbols of one concept.
struct SymbolEffect {
  std::vector<SymbolOutcome> outcomes;  ///< by symbol
  double change = 0;                    ///< Pr[the symbol does not stay]
  bool stays = false;                   ///< surely
};

/// What the model says of one action among certain other objects, as tables over the target's
/// symbols.
struct ActionTables {
  /// @param among the other objects, and the target's symbols of the concepts that stay.
  /// @param changeable the concepts whose symbol may be another one than in `among`.
  /// @param min_share outcomes with a smaller share of the most probable one are left out.
  /// @param guard once it has been stopped, the tables have no use
  ActionTables(const SymbolicModel& model, Action action, const Surroundings& among,
               const ConceptSet& changeable, double min_share, SearchGuard& guard);

  /// Whether the action changes the concept with more than that probability.
  bool changes(Concept which, double tolerance) const;

  bool is_defined;               ///< else it has no effect that was ever seen
  SymbolTable<double> legality;  ///< Pr[a | Omega]; 0 where the action is not defined
  std::array<SymbolTable<SymbolEffect>, kNumConcepts> effects;  ///< of the changeable concepts
};

/// Whether what an action does, or whether it is legal, depends on the other objects.
bool dependsOnOthers(const SymbolicModel& model, Action action);

/// Whether that of any action depends on objects of a TYPE symbol, [types].
std::vector<bool> watchedTypes(const SymbolicModel& model);

}  // namespace conceptplan
