#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace conceptplan {

/// The candidate that a mistyped name was most likely meant to be, by the number of letters to
/// insert, delete, replace or swap, ignoring case; nothing if none is near. Ties go to the earlier.
std::optional<std::string_view> nearestName(std::string_view name,
                                            std::span<const std::string_view> candidates);

/// "; did you mean \"belief\"?", or nothing if no candidate is near: the end of a message.
std::string didYouMean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace conceptplan
