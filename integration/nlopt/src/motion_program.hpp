#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "conceptplan/nlopt/motion_task.hpp"
#include "conceptplan/nlopt/refiner.hpp"

namespace conceptplan {

/// The refinement of one motion as a nonlinear program over the control points of its spline.
///
/// Least F = L + w J, where L is the length of the chords between the spline's samples, each
/// |d| smoothed to sqrt(|d|^2 + e^2) - e, and J the integral of the squared jerk; such that
/// - for each selected sample p and obstacle o with the sum of radii and clearance R:
///   (R^2 - |p - o|^2) / (2 R) <= 0 where the target is pushed. Where it may be lifted, the smooth
///   maximum of how far it is beside the obstacle, (|p - o|^2 - R^2) / (2 R), and above it is >= 0;
/// - control points keep to the workbench and to the box of the plan's way, and those of a step in
///   place to its cell. By the convex hull property of splines that holds between the samples too.
///
/// Variables are the control points between the first three and the last three: x and y of each,
/// then, where the target may be lifted, the lift of each. Headings stay as they are.
class MotionProgram {
 public:
  /// @param start a trajectory of the task, whose first and last three control points stay
  /// @param lifted actions on whose way the target may be lifted, [actions]; empty: none
  MotionProgram(const MotionTask& task, const RefinementOptions& options, const Trajectory& start,
                const std::vector<bool>& lifted);

  Eigen::Index numVariables() const { return numFree() * (may_lift_ ? 3 : 2); }
  const Eigen::VectorXd& lowerBounds() const { return lower_; }
  const Eigen::VectorXd& upperBounds() const { return upper_; }

  /// The variables of the trajectory, within the bounds; where it may be lifted, as high as clears
  /// all obstacles.
  Eigen::VectorXd startOf(const Trajectory& trajectory) const;
  Trajectory trajectoryOf(const Eigen::Ref<const Eigen::VectorXd>& variables) const;

  /// F; its gradient too, unless null. [numVariables]
  double objective(const Eigen::Ref<const Eigen::VectorXd>& variables, double* gradient) const;

  /// Adds constraints for each sample of the trajectory and obstacle that are nearer to each other
  /// than the wanted clearance and `reach_m`.
  /// @return how many are new.
  std::size_t select(const Trajectory& trajectory, double reach_m);
  std::size_t numConstraints() const { return selected_.size(); }

  /// The constraints, each <= 0, [numConstraints]; their gradients too, unless null,
  /// [numConstraints, numVariables] row by row.
  void constraints(const Eigen::Ref<const Eigen::VectorXd>& variables, double* values,
                   double* gradients) const;

 private:
  /// A point of the spline: weights of four control points in a row.
  struct Sample {
    Eigen::Index first;
    Eigen::Vector4d weights;
  };
  struct Pair {
    std::size_t sample;
    std::size_t obstacle;
    bool operator==(const Pair&) const = default;
  };

  Eigen::Index numFree() const { return std::max<Eigen::Index>(0, fixed_.cols() - 6); }
  /// x, y and lift of all control points.
  Eigen::Matrix3Xd pointsOf(const Eigen::Ref<const Eigen::VectorXd>& variables) const;
  /// Adds d/d(control point) to what belongs to it in a gradient, if it is free.
  void addTo(double* gradient, Eigen::Index column, const Eigen::Vector3d& derivative) const;
  void setBounds(const MotionTask& task, const RefinementOptions& options,
                 const std::vector<bool>& lifted);

  Trajectory::ControlPoints fixed_;  // of the start; the free ones are overwritten
  double span_s_;
  bool may_lift_;
  double jerk_factor_;  // w / span^5
  double clearance_m_;  // wanted, a little more than asked
  double target_radius_m_;
  std::vector<UprightCylinder> obstacles_;
  Eigen::VectorXd lower_;
  Eigen::VectorXd upper_;
  std::vector<Sample> samples_;
  std::vector<Pair> selected_;
};

}  // namespace conceptplan
