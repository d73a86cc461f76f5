#include <algorithm>
#include <cmath>
#include <limits>

#include "conceptplan/nlopt/motion_task.hpp"
#include "spline_basis.hpp"

namespace conceptplan {
namespace {

constexpr double kStep_m = 5e-4;

}  // namespace

double length_m(const Trajectory& trajectory) {
  const std::vector<MotionPoint> points = trajectory.denseSamples(kStep_m);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x_m - points[i - 1].x_m, points[i].y_m - points[i - 1].y_m);
  }
  return length;
}

double clearance_m(const MotionTask& task, const Trajectory& trajectory) {
  double least = std::numeric_limits<double>::infinity();
  for (const MotionPoint& point : trajectory.denseSamples(kStep_m)) {
    const UprightPrism target =
        task.target(waypointAfter(task, trajectory, point.time_s), {point.x_m, point.y_m});
    least = std::min(least, edgeClearance_m(task.workbench, target));
    for (const UprightPrism& obstacle : task.obstacles) {
      const double above_m = point.lift_m - obstacle.height_m;
      least = std::min(least, std::max(above_m, clearance_m(target, obstacle)));
    }
  }
  return least;
}

std::size_t waypointAfter(const MotionTask& task, const Trajectory& trajectory, double time_s) {
  const double actions = std::floor(time_s / (kSpansPerAction * trajectory.span_s()));
  return std::min(static_cast<std::size_t>(actions) + 1, task.waypoints.size() - 1);
}

double squaredJerk(const Trajectory& trajectory) {
  const Trajectory::ControlPoints& points = trajectory.controlPoints();
  double sum = 0;
  for (int i = 0; i < trajectory.numSpans(); ++i) {
    const Eigen::Vector4d third =
        points.col(i + 3) - 3 * points.col(i + 2) + 3 * points.col(i + 1) - points.col(i);
    sum += third[0] * third[0] + third[1] * third[1] + third[3] * third[3];
  }
  return sum / std::pow(trajectory.span_s(), 5);
}

}  // namespace conceptplan
