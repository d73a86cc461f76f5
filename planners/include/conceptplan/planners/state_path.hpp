#pragma once

#include <cstdint>
#include <vector>

#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// Costs of paths, counted in billionths of a nat: sums are exact, so equal ones are equal whatever
/// the order of their terms.
using PathCost = std::int64_t;

inline constexpr PathCost kNat = 1'000'000'000;

/// Rounded to the nearest billionth.
PathCost toPathCost(double nats);
double toNats(PathCost cost);

/// An action sequence with the states that it passes.
struct StatePath {
  ActionSequence actions;
  std::vector<StateId> states;  ///< after each action
  PathCost cost = 0;
};

}  // namespace conceptplan
