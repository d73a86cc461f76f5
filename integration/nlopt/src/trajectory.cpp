#include "conceptplan/nlopt/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "spline_basis.hpp"

namespace conceptplan {

Trajectory::Trajectory(ControlPoints control_points, double span_s)
    : control_points_(std::move(control_points)), span_s_(span_s) {
  if (control_points_.cols() < 3) {
    throw std::invalid_argument("a trajectory of " + std::to_string(control_points_.cols()) +
                                " control points, expected at least 3");
  }
  if (!(std::isfinite(span_s) && span_s > 0)) {
    throw std::invalid_argument("span_s is " + std::to_string(span_s) + ", expected > 0");
  }
}

MotionPoint Trajectory::at(double time_s) const {
  if (numSpans() == 0) {
    const Eigen::Vector4d pose = control_points_.col(0);
    return {0, pose[0], pose[1], pose[2], pose[3]};
  }
  const double time = std::clamp(time_s, 0.0, duration_s());
  const int span = std::min(static_cast<int>(time / span_s_), numSpans() - 1);
  const Eigen::Vector4d pose =
      control_points_.middleCols<4>(span) * splineWeights(time / span_s_ - span);
  return {time, pose[0], pose[1], pose[2], pose[3]};
}

std::vector<MotionPoint> Trajectory::samples(double step_s) const {
  const int steps = static_cast<int>(std::ceil(duration_s() / step_s - 1e-9));
  std::vector<MotionPoint> points;
  for (int i = 0; i < steps; ++i) points.push_back(at(i * duration_s() / steps));
  points.push_back(at(duration_s()));
  return points;
}

std::vector<MotionPoint> Trajectory::denseSamples(double step_m) const {
  std::vector<MotionPoint> points;
  for (int span = 0; span < numSpans(); ++span) {
    // No speed in a span is above the greatest difference of its control points.
    double fastest_m = 0;
    for (int i = span; i < span + 3; ++i) {
      const Eigen::Vector4d difference = control_points_.col(i + 1) - control_points_.col(i);
      fastest_m = std::max(fastest_m, std::hypot(difference[0], difference[1], difference[3]));
    }
    const int steps = std::max(1, static_cast<int>(std::ceil(fastest_m / step_m)));
    for (int i = 0; i < steps; ++i) {
      points.push_back(at((span + static_cast<double>(i) / steps) * span_s_));
    }
  }
  points.push_back(at(duration_s()));
  return points;
}

bool Trajectory::operator==(const Trajectory& other) const {
  return span_s_ == other.span_s_ && control_points_.cols() == other.control_points_.cols() &&
         control_points_ == other.control_points_;
}

}  // namespace conceptplan
