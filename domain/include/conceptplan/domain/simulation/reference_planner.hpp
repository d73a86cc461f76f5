#pragma once

#include <optional>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/domain/world.hpp"

namespace conceptplan {

/// A shortest plan that takes the target to exactly `goal`, drawn uniformly from all shortest ones;
/// nothing if there is none. It knows the simulator's rules: it makes the references of tasks and
/// is the yardstick of tests, never a planner of the product.
///
/// Breadth-first over position, rotation and colour: at most 360 states on 3 x 5 cells.
/// @throws std::invalid_argument if `world.target` is not an object.
std::optional<ActionSequence> shortestPlan(const World& world, const ObjectState& goal,
                                           RandomStream& random);

}  // namespace conceptplan
