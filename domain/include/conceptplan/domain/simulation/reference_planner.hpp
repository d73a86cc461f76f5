#pragma once

#include <optional>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/domain/task.hpp"
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

/// Actions with the object that each of them moves.
struct JointSequence {
  ActionSequence actions;
  std::vector<std::size_t> moved;  ///< [actions]
};

/// A shortest plan that takes every target of a task to exactly its goal; nothing if there is none.
/// The same use, and the same search over the states of all targets: up to 129,600 for two of them.
/// @throws std::invalid_argument if a target is not an object.
std::optional<JointSequence> shortestJointPlan(const Task& task);

}  // namespace conceptplan
