#include "conceptplan/nlopt/motion_task.hpp"

#include <algorithm>
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

/// What an outline covers while it turns a quarter turn.
Outline turning(const Outline& outline) {
  const OutlineBox box = boxOf(outline);
  const double widest_m = std::max(-box.low_m.minCoeff(), box.high_m.maxCoeff());
  return clipped(outlineOfDisc(circumradius_m(outline)), outlineOfSquare(widest_m));
}

}  // namespace

MotionTask motionTaskOf(const SymbolicProblem& problem, const SymbolGrounding& grounding,
                        const Plan& plan, double max_half_width_cells) {
  if (plan.predicted.size() != plan.actions.size()) {
    throw std::invalid_argument("a plan of " + std::to_string(plan.actions.size()) +
                                " actions with " + std::to_string(plan.predicted.size()) +
                                " predicted states");
  }
  const SymbolicScene& scene = problem.initial;
  MotionTask task;
  task.workbench = scene.workbench;
  const auto standing = [&](const Symbols& symbols) {
    return prismOf(scene.workbench, grounding, symbols, max_half_width_cells);
  };
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (i != scene.target) task.obstacles.push_back(standing(mostProbable(scene.objects[i])));
  }
  Symbols before = mostProbable(scene.objects[scene.target]);
  UprightPrism target = standing(before);
  task.height_m = target.height_m;
  task.waypoints.push_back({target.p_WCentre, 0, target.outline, false});
  for (std::size_t i = 0; i < plan.actions.size(); ++i) {
    const Symbols& after = plan.predicted[i];
    const std::size_t rotation = index(Concept::kRotation);
    const UprightPrism there = standing(after);
    MotionWaypoint waypoint{there.p_WCentre, task.waypoints.back().heading_rad,
                            unionOf(target.outline, there.outline),
                            grounding.cell(after) == grounding.cell(before)};
    const double turn_rad = after[rotation] != before[rotation] ? turnOf(plan.actions[i]) : 0;
    if (turn_rad != 0) {
      waypoint.heading_rad += turn_rad;
      waypoint.outline = turning(waypoint.outline);
    }
    task.waypoints.push_back(waypoint);
    target = there;
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
