#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/pipeline/report.hpp"

namespace conceptplan::report {

/// "Type", "Column", "Row", "Rotation", "Color" or "Size".
std::string_view heading(Concept which);

/// A reason in the page's words, as a sentence: "COLOR must change" reads "Color must change.";
/// escaped. Empty stays empty.
std::string reasonText(const Report& report);

/// What the report calls a symbol; escaped.
std::string symbolName(const Report& report, Concept which, SymbolId symbol);

/// A CSS colour for the name of a colour; empty for a name that is none.
std::string_view cssColor(std::string_view color_name);

/// A small square in the colour that the symbol is named after; empty if it is not a colour.
std::string colorKey(const Report& report, Concept which, SymbolId symbol);

/// The id of an object in the masks.
int instance(const Report& report, std::size_t object);

/// What `conceptplan::objectName` calls an object, e.g. "Cup 2"; escaped.
std::string objectName(const Report& report, std::size_t object);

/// The targets with what they should become.
std::vector<TargetGoal> targetsOf(const Report& report);
bool isTarget(const Report& report, std::size_t object);

/// The object that a step of a plan moves.
std::size_t movedObject(const Report& report, const Plan& plan, std::size_t step);

/// "Cup 2: ", what a step begins with where there are several targets; else empty. Escaped.
std::string movedName(const Report& report, const Plan& plan, std::size_t step);

/// "move front"; escaped.
std::string words(Action action);

/// The sign of an action, for use beside its words.
std::string icon(Action action);

}  // namespace conceptplan::report
