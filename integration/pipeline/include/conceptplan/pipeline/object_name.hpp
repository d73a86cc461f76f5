#pragma once

#include <string>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/symbols.hpp"

namespace conceptplan {

/// What a person calls an object: its most probable type and its id in the masks, "Cup 2"; where
/// the type has no name, "object 2".
std::string objectName(const SymbolGrounding& grounding, const SymbolBelief& belief, int instance);

}  // namespace conceptplan
