#pragma once

#include <cstdint>
#include <functional>

#include "conceptplan/planners/search_guard.hpp"
#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

/// Some of a target's other objects, by number among them, as bits.
using ObstacleSet = std::uint32_t;

/// Objects of higher numbers are in no set: they are never taken away.
inline constexpr std::size_t kMostObjects = 20;

/// The object that a verdict names; none if it is no collision.
ObstacleSet collidedObject(const Verdict& verdict);

/// Whether a state can be once the objects are taken away. One that meets several objects counts
/// for the one that its verdict names.
inline bool isPassable(const Verdict& verdict, ObstacleSet removed) {
  return verdict.valid() || (collidedObject(verdict) & removed) != 0;
}

/// The fewest of the objects without which there is a way, of these the first by number; none if
/// not all are enough, if finding them grew too long, or if a limit strikes.
/// @param num_states that `leads_without` may look at in one call
ObstacleSet fewestBlocking(ObstacleSet all, std::size_t num_states,
                           const std::function<bool(ObstacleSet removed)>& leads_without,
                           SearchGuard& guard);

}  // namespace conceptplan
