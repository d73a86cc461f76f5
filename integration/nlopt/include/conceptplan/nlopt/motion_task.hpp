#pragma once

#include <vector>

#include "conceptplan/domain/model/upright_prism.hpp"
#include "conceptplan/nlopt/trajectory.hpp"
#include "conceptplan/planners/plan_result.hpp"

namespace conceptplan {

/// Where the target is after a step of a plan.
struct MotionWaypoint {
  Eigen::Vector2d p_W;
  double heading_rad = 0;  ///< turned since the start
  /// What the target covers about its place while it comes here and when it is here.
  Outline outline;
  /// Whether the step was taken within the cell, as turns and changes of colour are. Such a step
  /// belongs to its place; a move only to where it leads.
  bool in_place = false;
};

/// The motion that a symbolic plan asks for, in space.
struct MotionTask {
  Workbench workbench;
  double height_m = 0;                    ///< of the target
  std::vector<MotionWaypoint> waypoints;  ///< the start, then one an action; at least one
  std::vector<UprightPrism> obstacles;

  /// The target at a place, as it is on the way to that waypoint.
  UprightPrism target(std::size_t waypoint, const Eigen::Vector2d& p_W) const {
    return {p_W, waypoints[waypoint].outline, height_m};
  }
};

/// Most probable symbols stand for the objects, and the plan's predicted symbols for its steps. An
/// action that leaves the position symbols alone is a step in place; `rotate_left` and
/// `rotate_right` that change the ROTATION symbol turn a quarter turn. While it turns the target
/// covers the disc of its farthest corner, but no more than the square around what it covers before
/// and after: a corner that swings out further passes over what stands there.
/// @throws std::invalid_argument if the plan has not one predicted state an action.
MotionTask motionTaskOf(const SymbolicProblem& problem, const SymbolGrounding& grounding,
                        const Plan& plan, double max_half_width_cells = kMaxHalfWidthCells);

/// The plan as it is: from waypoint to waypoint on straight lines, at rest in each. Three spans an
/// action.
Trajectory discreteTrajectory(const MotionTask& task, double action_s);

/// The waypoint to which a trajectory of the task leads at that time, in [0, duration]; the last
/// one at the end.
std::size_t waypointAfter(const MotionTask& task, const Trajectory& trajectory, double time_s);

/// Length of the way over the workbench, seen from above, metres.
double length_m(const Trajectory& trajectory);

/// The least clearance of the target on the trajectory to any obstacle and to the workbench's edge,
/// metres, at steps of half a millimetre. To an obstacle it is the larger of the gap between the
/// outlines and the height above its top: what prisms grown by it would just keep.
double clearance_m(const MotionTask& task, const Trajectory& trajectory);

/// Integral of the squared jerk of the position, lift included, m^2 / s^5.
double squaredJerk(const Trajectory& trajectory);

}  // namespace conceptplan
