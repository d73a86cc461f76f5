#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/symbols.hpp"

namespace conceptplan {

/// A function of the target's symbols, as a table over no more concepts than determine it.
struct MinimalTable {
  std::vector<Concept> concepts;                       ///< in the order of kConcepts
  std::map<std::vector<SymbolId>, std::int64_t> rows;  ///< symbols of these concepts -> value

  /// Whether the value is the same wherever the function is defined.
  bool isConstant() const { return concepts.empty(); }
};

/// The symbols of some of the concepts.
std::vector<SymbolId> pick(const Symbols& symbols, const std::vector<Concept>& concepts);

/// Drops concepts from the candidates, one after the other, as long as the others still determine
/// the value.
/// @param states where the function is defined, each once
/// @param values of the function, [states]
/// @param kept is not dropped
MinimalTable minimalTable(const std::vector<Symbols>& states,
                          const std::vector<std::int64_t>& values,
                          const std::vector<Concept>& candidates,
                          const ConceptCardinality& cardinality, std::optional<Concept> kept = {});

}  // namespace conceptplan
