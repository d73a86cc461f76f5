#pragma once

#include <string>
#include <string_view>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/concept.hpp"
#include "conceptplan/domain/symbols.hpp"

namespace conceptplan {

/// ASCII letters in lower case.
std::string lowerCase(std::string_view text);

/// Letters, digits and "_" of a text in lower case, all else as "-"; begins with a letter.
std::string pddlName(std::string_view text);

/// "color".
std::string typeName(Concept which);

/// "color-3".
std::string objectName(Concept which, SymbolId symbol);

/// "(target_color VALUE)".
std::string targetAtom(Concept which, const std::string& value);

/// "(target_color color-3)".
std::string targetFact(Concept which, SymbolId symbol);

}  // namespace conceptplan
