#pragma once

#include <Eigen/Core>
#include <vector>

namespace conceptplan {

/// Where the target is at one time, in the workbench's frame W.
struct MotionPoint {
  double time_s = 0;
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;  ///< turned since the start, counter-clockwise seen from above
  double lift_m = 0;       ///< height of its underside above the workbench

  bool operator==(const MotionPoint&) const = default;
};

/// A time-parameterised motion: a uniform cubic B-spline of position, heading and lift. So
/// velocity and acceleration are continuous, jerk is constant within a span, and each span lies in
/// the convex hull of its four control points. Immutable.
///
/// Where three control points in a row are equal the target stands still at that point.
/// Source: C. de Boor, "A Practical Guide to Splines", 1978.
class Trajectory {
 public:
  /// Rows of the control points: x_m, y_m, heading_rad, lift_m.
  using ControlPoints = Eigen::Matrix<double, 4, Eigen::Dynamic>;

  /// @param control_points [4, spans + 3]; those of no span at all are equal
  /// @param span_s duration of a span, > 0
  /// @throws std::invalid_argument for fewer than 3 control points, or a duration out of range.
  Trajectory(ControlPoints control_points, double span_s);

  const ControlPoints& controlPoints() const { return control_points_; }
  int numSpans() const { return static_cast<int>(control_points_.cols()) - 3; }
  double span_s() const { return span_s_; }
  double duration_s() const { return numSpans() * span_s_; }

  /// Times before the start and after the end give the start and the end.
  MotionPoint at(double time_s) const;

  /// Points from start to end, both included, at equal steps of time of at most `step_s`.
  std::vector<MotionPoint> samples(double step_s) const;

  /// Points from start to end, no two neighbours further apart than `step_m` in space, turned by
  /// whatever angle.
  std::vector<MotionPoint> denseSamples(double step_m) const;

  bool operator==(const Trajectory& other) const;

 private:
  ControlPoints control_points_;
  double span_s_;
};

}  // namespace conceptplan
