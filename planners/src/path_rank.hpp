#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "conceptplan/planners/state_path.hpp"

namespace conceptplan {

/// A cost and, behind it, a number of steps, as one number: of two ways of equal cost the one of
/// fewer steps is less, and ranks of the parts of a way add up to that of the way.
using PathRank = std::int64_t;

inline constexpr PathRank kStepsPerRank = 1 << 17;
inline constexpr std::size_t kMostSteps = kStepsPerRank - 1;

/// Where no path leads, in whatever unit.
inline constexpr PathCost kOutOfReach = std::numeric_limits<PathCost>::max();

/// No step and no least cost is told beyond this, a rank's 8,796 nats. A heuristic that is
/// consistent stays so if its numbers are cut off.
inline constexpr PathRank kFarthest = PathRank{1} << 60;

/// So far ways can be told apart, 52,776 nats: one more step and the rest do not overflow.
inline constexpr PathRank kMostRank = kOutOfReach - 2 * kFarthest;

constexpr PathCost costOf(PathRank rank) { return rank / kStepsPerRank; }
constexpr std::size_t stepsOf(PathRank rank) {
  return static_cast<std::uint64_t>(rank) % kStepsPerRank;
}

/// @pre cost <= costOf(kMostRank), steps <= kMostSteps
constexpr PathRank rankOf(PathCost cost, std::size_t steps) {
  assert(cost <= costOf(kMostRank) && steps <= kMostSteps);
  return cost * kStepsPerRank + static_cast<PathRank>(steps);
}

}  // namespace conceptplan
