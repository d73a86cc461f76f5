#pragma once

#include <string>

#include "conceptplan/domain/model/symbol_grounding.hpp"

namespace conceptplan {

/// @param place stands in the message, e.g. "object 2".
/// @throws std::invalid_argument if a concept has another number of symbols than its cardinality,
/// or no distribution over them.
void checkBelief(const SymbolBelief& belief, const ConceptCardinality& cardinality,
                 const std::string& place);

}  // namespace conceptplan
