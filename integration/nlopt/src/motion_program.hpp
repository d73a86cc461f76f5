#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "conceptplan/nlopt/motion_task.hpp"
#include "conceptplan/nlopt/refiner.hpp"

namespace conceptplan {

/// The refinement of one motion as a nonlinear program over the control points of its spline.
///
/// Least F = L + w J, where L is the length of the chords between the spline's samples, each
/// |d| smoothed to sqrt(|d|^2 + e^2) - e, and J the integral of the squared jerk; such that
/// - for each selected sample p and obstacle o, the smooth maximum over the directions n_k of the
///   gap n_k . (p - o) - H_k is >= 0 where the target is pushed; H_k is the sum of both supports
///   and the clearance. Where it may be lifted, the smooth maximum of that and how far it is above;
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

  /// Adds constraints for each coarse sample of the trajectory and obstacle that are nearer to each
  /// other than the wanted clearance and `reach_m`.
  /// @return how many are new.
  std::size_t select(const Trajectory& trajectory, double reach_m);
  /// The same for each fine sample that is nearer than the wanted clearance.
  std::size_t selectOverlooked(const Trajectory& trajectory);
  /// Wants that much more clearance, and a little.
  void keepFurther(double more_m) { clearance_m_ += more_m + kMore_m; }
  std::size_t numConstraints() const { return selected_.size(); }

  /// The constraints, each <= 0, [numConstraints]; their gradients too, unless null,
  /// [numConstraints, numVariables] row by row.
  void constraints(const Eigen::Ref<const Eigen::VectorXd>& variables, double* values,
                   double* gradients) const;

 private:
  static constexpr double kMore_m = 1e-4;

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

  /// How far the target, as it is in the action of the sample and at that place, is beside the
  /// obstacle along each direction, less the clearance.
  std::array<double, Outline::kDirections> gapsBeside_m(const Pair& pair,
                                                        const Eigen::Vector2d& p_W) const;

  std::size_t select(const Trajectory& trajectory, double reach_m, std::size_t stride);
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
  double jerk_factor_;             // w / span^5
  double clearance_m_;             // wanted, a little more than asked
  std::vector<Outline> outlines_;  // of the target, [actions]
  std::vector<UprightPrism> obstacles_;
  Eigen::VectorXd lower_;
  Eigen::VectorXd upper_;
  std::vector<Sample> samples_;  // fine ones
  std::vector<Pair> selected_;
};

}  // namespace conceptplan
