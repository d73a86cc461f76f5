#pragma once

#include <string>

#include "conceptplan/domain/concept.hpp"

namespace conceptplan {

/// The key of a concept in scenarios and results: "position_x".
std::string symbolKey(Concept which);

}  // namespace conceptplan
