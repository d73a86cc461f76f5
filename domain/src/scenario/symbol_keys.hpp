#pragma once

#include <string>

#include "conceptplan/domain/symbol_key.hpp"

namespace conceptplan {

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
