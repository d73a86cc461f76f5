#pragma once

#include <optional>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// The task with one of its obstacles as a second target, drawn uniformly, and a shortest plan for
/// both. Its goal is another cell, uniform over those that no goal and nothing that stands still
/// has; at level 3 in half of the tasks also the dyer's colour, at level 4 also a rotation uniform
/// over the quarter turns. Nothing where no goal can be reached together with the first one.
/// @throws std::invalid_argument if the task has no obstacle, as at level 1.
std::optional<Task> withSecondTarget(Task task, RandomStream& random);

}  // namespace conceptplan
