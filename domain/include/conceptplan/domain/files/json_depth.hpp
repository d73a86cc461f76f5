#pragma once

#include <string_view>

namespace conceptplan {

/// More levels of lists and objects than any of our files has.
inline constexpr int kMostJsonLevels = 64;

/// Whether lists and objects of a JSON text are nested more than 64 deep. Such a text is hostile:
/// it parses, but copying or printing the document would overflow the stack. Brackets within
/// strings do not count; a text that is no JSON may give either answer.
bool nestsTooDeep(std::string_view json);

}  // namespace conceptplan
