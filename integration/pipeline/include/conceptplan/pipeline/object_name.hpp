#pragma once

#include <string>
#include <vector>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/symbols.hpp"

namespace conceptplan {

/// What a person calls an object: its most probable type and its id in the masks, "Cup 2"; where
/// the type has no name, "object 2".
std::string objectName(const SymbolGrounding& grounding, const SymbolBelief& belief, int instance);

/// "Cup 1", "Cup 1 and Pot 2", "Cup 1, Pot 2 and Pot 3".
std::string listed(const std::vector<std::string>& names);

}  // namespace conceptplan
