#pragma once

#include <algorithm>
#include <cctype>
#include <string>

#include "conceptplan/domain/concept.hpp"

namespace conceptplan {

/// The key of a concept in a scenario file: "position_x".
inline std::string symbolKey(Concept which) {
  std::string key(name(which));
  std::transform(key.begin(), key.end(), key.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return key;
}

inline constexpr const char* kGoalSymbolsKey = "goal.symbols";

/// The full key of an object in the list: "initial.symbols.objects[0]".
inline std::string objectKey(std::size_t object) {
  return "initial.symbols.objects[" + std::to_string(object) + "]";
}

/// The full key of a goal in the list for several targets: "goal.symbols[0]".
inline std::string goalKey(std::size_t target) {
  return std::string(kGoalSymbolsKey) + "[" + std::to_string(target) + "]";
}

}  // namespace conceptplan
