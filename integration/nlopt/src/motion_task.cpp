#include "conceptplan/nlopt/motion_task.hpp"

#include <numbers>
#include <stdexcept>
#include <string>

#include "spline_basis.hpp"

namespace conceptplan {
namespace {

double turnOf(Action action) {
  if (action == Action::kRotateLeft) return std::numbers::pi / 2;
  if (action == Action::kRotateRight) return -std::numbers::pi / 2;
  return 0;
}

}  // namespace

MotionTask motionTaskOf(const SymbolicProblem& problem, const SymbolGrounding& grounding,
                        const Plan& plan, double max_radius_cells) {
  if (plan.predicted.size() != plan.actions.size()) {
    throw std::invalid_argument("a plan of " + std::to_string(plan.actions.size()) +
                                " actions with " + std::to_string(plan.predicted.size()) +
                                " predicted states");
  }
  const SymbolicScene& scene = problem.initial;
  MotionTask task;
  task.workbench = scene.workbench;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const UprightCylinder cylinder =
        cylinderOf(scene.workbench, grounding, mostProbable(scene.objects[i]), max_radius_cells);
    if (i == scene.target) {
      task.target = cylinder;
    } else {
      task.obstacles.push_back(cylinder);
    }
  }
  Symbols before = mostProbable(scene.objects[scene.target]);
  task.waypoints.push_back({task.target.p_WCentre, 0, false});
  for (std::size_t i = 0; i < plan.actions.size(); ++i) {
    const Symbols& after = plan.predicted[i];
    const std::size_t rotation = index(Concept::kRotation);
    MotionWaypoint waypoint = task.waypoints.back();
    waypoint.p_W = scene.workbench.p_WCell(grounding.cell(after));
    waypoint.in_place = grounding.cell(after) == grounding.cell(before);
    if (after[rotation] != before[rotation]) waypoint.heading_rad += turnOf(plan.actions[i]);
    task.waypoints.push_back(waypoint);
    before = after;
  }
  return task;
}

Trajectory discreteTrajectory(const MotionTask& task, double action_s) {
  Trajectory::ControlPoints points(4, 3 * static_cast<Eigen::Index>(task.waypoints.size()));
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    const MotionWaypoint& waypoint = task.waypoints[i];
    points.middleCols<3>(3 * static_cast<Eigen::Index>(i)).colwise() =
        Eigen::Vector4d(waypoint.p_W.x(), waypoint.p_W.y(), waypoint.heading_rad, 0);
  }
  return {std::move(points), action_s / kSpansPerAction};
}

}  // namespace conceptplan
