#pragma once

#include "conceptplan/nlopt/motion_task.hpp"

namespace conceptplan::testing {

/// The motion of the best plan of `bfs` for a generated test task, from true symbols and learned
/// transitions, with FCL validity. Footprints are as large as those that the shipped model measured
/// of objects of each size: discs, squares and planks up to 85 mm from the middle of cells of 200
/// mm.
MotionTask plannedMotion(int level, int number);

/// Whether FCL finds the target, grown by the clearance to all sides, clear of every obstacle at
/// steps of 1 mm of its way, and the corners of its poses as far from the edge.
bool isClear(const MotionTask& task, const Trajectory& trajectory, double clearance_m);

}  // namespace conceptplan::testing
