#pragma once

#include <cstddef>
#include <vector>

#include "conceptplan/domain/object.hpp"
#include "conceptplan/domain/workbench.hpp"

namespace conceptplan {

/// Everything on one workbench: ground truth for the simulator and the renderer, never for a
/// planner. Instance id i + 1 of a mask belongs to objects[i]; 0 is the background.
struct World {
  Workbench workbench;
  std::vector<ObjectState> objects;
  std::size_t target = 0;  ///< index into `objects` of the object that the actions move

  bool operator==(const World&) const = default;
};

}  // namespace conceptplan
