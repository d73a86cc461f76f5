#include "motion_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "spline_basis.hpp"

namespace conceptplan {
namespace {

constexpr int kSamplesPerSpan = 4;  // coarse ones: of the length, and watched from the start
constexpr int kFine = 4;            // fine ones for each of them
constexpr double kChordSmoothing_m = 5e-4;  // e
constexpr double kSlack_m = 5e-4;           // for what the spline does between two samples
constexpr double kLiftSlack_m = 3e-3;       // the same where it rises beside an edge
constexpr double kSharpness_1_m = 2000;     // of smooth maxima; they are at most 0.35 mm too low
constexpr double kNegligible = 40;          // of the exponents in them: exp(-40) adds no bit

/// log((exp(k a) + exp(k b)) / 2) / k: below max(a, b), and smooth.
double smoothMaximum(double a, double b) {
  const double far = kSharpness_1_m * std::abs(a - b);
  return std::max(a, b) + std::log(0.5 * (1 + std::exp(-far))) / kSharpness_1_m;
}

/// log(sum_k exp(c x_k) / 2) / c, smooth, for the x_k of directions n_k: the maximum where two of
/// them are equal, less where it is one alone. And its derivative sum_k w_k n_k to what moves them.
double smoothMaximum(const std::array<double, Outline::kDirections>& along,
                     Eigen::Vector2d& derivative) {
  const double greatest = std::ranges::max(along);
  double sum = 0;
  derivative.setZero();
  for (std::size_t k = 0; k < along.size(); ++k) {
    const double behind = kSharpness_1_m * (greatest - along[k]);
    if (behind > kNegligible) continue;
    const double weight = std::exp(-behind);
    sum += weight;
    derivative += weight * outlineDirection(k);
  }
  derivative /= sum;
  return greatest + std::log(0.5 * sum) / kSharpness_1_m;
}

/// Derivative of the smooth maximum to a; that to b is the rest to one.
double shareOfFirst(double a, double b) { return 1 / (1 + std::exp(kSharpness_1_m * (b - a))); }

}  // namespace

MotionProgram::MotionProgram(const MotionTask& task, const RefinementOptions& options,
                             const Trajectory& start, const std::vector<bool>& lifted)
    : fixed_(start.controlPoints()),
      span_s_(start.span_s()),
      may_lift_(std::find(lifted.begin(), lifted.end(), true) != lifted.end()),
      jerk_factor_(options.jerk_weight / std::pow(span_s_, 5)),
      clearance_m_(options.clearance_m + (may_lift_ ? kLiftSlack_m : kSlack_m)),
      obstacles_(task.obstacles) {
  constexpr int kPerSpan = kSamplesPerSpan * kFine;
  for (int i = 0; i < start.numSpans() * kPerSpan; ++i) {
    const double share = static_cast<double>(i % kPerSpan) / kPerSpan;
    samples_.push_back({i / kPerSpan, splineWeights(share)});
  }
  for (std::size_t i = 1; i < task.waypoints.size(); ++i) {
    outlines_.push_back(task.waypoints[i].outline);
  }
  setBounds(task, options, lifted);
}

void MotionProgram::setBounds(const MotionTask& task, const RefinementOptions& options,
                              const std::vector<bool>& lifted) {
  const Workbench& bench = task.workbench;
  // A way that leaves the box of the plan's own is longer than what of it lies in the box.
  const auto ways = fixed_.topRows<2>().array();
  Eigen::Array3Xd low = Eigen::Array3Xd::Zero(3, fixed_.cols());
  low.topRows<2>().colwise() = ways.rowwise().minCoeff().eval();
  Eigen::Array3Xd high = Eigen::Array3Xd::Zero(3, fixed_.cols());
  high.topRows<2>().colwise() = ways.rowwise().maxCoeff().eval();
  // Action i runs over the spans of waypoint i, which six control points shape.
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    const Eigen::Index first = kSpansPerAction * static_cast<Eigen::Index>(i);
    if (!lifted.empty() && lifted[i]) high.row(2).segment<6>(first) = options.max_lift_m;
    const OutlineBox box = boxOf(outlines_[i]);
    const Eigen::Array2d half_m =
        0.5 * bench.cell_m * Eigen::Array2d(bench.columns, bench.rows) - options.clearance_m;
    const Eigen::Array2d lowest = -half_m - box.low_m.array();
    const Eigen::Array2d highest = half_m - box.high_m.array();
    for (Eigen::Index column = first; column < first + 6; ++column) {
      low.col(column).head<2>() = low.col(column).head<2>().max(lowest);
      high.col(column).head<2>() = high.col(column).head<2>().min(highest);
    }
  }
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    if (!task.waypoints[i + 1].in_place) continue;
    const Eigen::Index first = kSpansPerAction * static_cast<Eigen::Index>(i);
    const Eigen::Array2d p_W = task.waypoints[i + 1].p_W.array();
    const double reach_m = options.cell_reach * bench.cell_m;
    for (Eigen::Index column = first; column < first + 6; ++column) {
      low.col(column).head<2>() = low.col(column).head<2>().max(p_W - reach_m);
      high.col(column).head<2>() = high.col(column).head<2>().min(p_W + reach_m);
      high(2, column) = 0;
    }
  }
  const Eigen::Index rows = may_lift_ ? 3 : 2;
  lower_ = low.block(0, 3, rows, numFree()).reshaped();
  upper_ = high.block(0, 3, rows, numFree()).reshaped();
}

Eigen::VectorXd MotionProgram::startOf(const Trajectory& trajectory) const {
  double highest_m = 0;
  for (const UprightPrism& obstacle : obstacles_) {
    highest_m = std::max(highest_m, obstacle.height_m);
  }
  Eigen::Matrix3Xd points(3, numFree());
  points.topRows<2>() = trajectory.controlPoints().block(0, 3, 2, numFree());
  points.row(2).setConstant(highest_m + clearance_m_);
  return points.topRows(may_lift_ ? 3 : 2).reshaped().cwiseMax(lower_).cwiseMin(upper_);
}

Trajectory MotionProgram::trajectoryOf(const Eigen::Ref<const Eigen::VectorXd>& variables) const {
  const Eigen::Matrix3Xd points = pointsOf(variables);
  Trajectory::ControlPoints all = fixed_;
  all.topRows<2>() = points.topRows<2>();
  all.row(3) = points.row(2);
  return {std::move(all), span_s_};
}

Eigen::Matrix3Xd MotionProgram::pointsOf(const Eigen::Ref<const Eigen::VectorXd>& variables) const {
  Eigen::Matrix3Xd points(3, fixed_.cols());
  points.topRows<2>() = fixed_.topRows<2>();
  points.row(2) = fixed_.row(3);
  const Eigen::Index rows = may_lift_ ? 3 : 2;
  points.block(0, 3, rows, numFree()) = variables.reshaped(rows, numFree());
  return points;
}

void MotionProgram::addTo(double* gradient, Eigen::Index column,
                          const Eigen::Vector3d& derivative) const {
  if (column < 3 || column >= 3 + numFree()) return;
  const Eigen::Index rows = may_lift_ ? 3 : 2;
  for (Eigen::Index row = 0; row < rows; ++row) {
    gradient[rows * (column - 3) + row] += derivative[row];
  }
}

double MotionProgram::objective(const Eigen::Ref<const Eigen::VectorXd>& variables,
                                double* gradient) const {
  const Eigen::Matrix3Xd points = pointsOf(variables);
  if (gradient != nullptr) std::fill_n(gradient, numVariables(), 0.0);
  double value = 0;
  const auto at = [&](const Sample& sample) -> Eigen::Vector3d {
    return points.middleCols<4>(sample.first) * sample.weights;
  };
  for (std::size_t i = 0; i < samples_.size(); i += kFine) {
    const Sample& from = samples_[i];
    const Sample to =
        i + kFine < samples_.size() ? samples_[i + kFine] : Sample{from.first, splineWeights(1)};
    const Eigen::Vector3d chord = at(to) - at(from);
    const double length = std::sqrt(chord.squaredNorm() + kChordSmoothing_m * kChordSmoothing_m);
    value += length - kChordSmoothing_m;
    if (gradient == nullptr) continue;
    for (Eigen::Index k = 0; k < 4; ++k) {
      addTo(gradient, to.first + k, to.weights[k] / length * chord);
      addTo(gradient, from.first + k, -from.weights[k] / length * chord);
    }
  }
  const Eigen::Vector4d third_difference(-1, 3, -3, 1);
  for (Eigen::Index i = 0; i + 3 < points.cols(); ++i) {
    const Eigen::Vector3d third = points.middleCols<4>(i) * third_difference;
    value += jerk_factor_ * third.squaredNorm();
    if (gradient == nullptr) continue;
    for (Eigen::Index k = 0; k < 4; ++k) {
      addTo(gradient, i + k, 2 * jerk_factor_ * third_difference[k] * third);
    }
  }
  return value;
}

std::size_t MotionProgram::select(const Trajectory& trajectory, double reach_m) {
  return select(trajectory, reach_m, kFine);
}

std::size_t MotionProgram::selectOverlooked(const Trajectory& trajectory) {
  return select(trajectory, 0, 1);
}

std::size_t MotionProgram::select(const Trajectory& trajectory, double reach_m,
                                  std::size_t stride) {
  const std::size_t before = selected_.size();
  for (std::size_t i = stride; i < samples_.size(); i += stride) {
    const Eigen::Vector2d p_W =
        trajectory.controlPoints().middleCols<4>(samples_[i].first).topRows<2>() *
        samples_[i].weights;
    for (std::size_t k = 0; k < obstacles_.size(); ++k) {
      const Pair pair{i, k};
      if (std::ranges::max(gapsBeside_m(pair, p_W)) > reach_m) continue;
      if (std::find(selected_.begin(), selected_.end(), pair) == selected_.end()) {
        selected_.push_back(pair);
      }
    }
  }
  return selected_.size() - before;
}

std::array<double, Outline::kDirections> MotionProgram::gapsBeside_m(
    const Pair& pair, const Eigen::Vector2d& p_W) const {
  const auto action = static_cast<std::size_t>(samples_[pair.sample].first / kSpansPerAction);
  const UprightPrism& obstacle = obstacles_[pair.obstacle];
  auto gaps = gaps_m(outlines_[action], p_W, obstacle.outline, obstacle.p_WCentre);
  for (double& gap_m : gaps) gap_m -= clearance_m_;
  return gaps;
}

void MotionProgram::constraints(const Eigen::Ref<const Eigen::VectorXd>& variables, double* values,
                                double* gradients) const {
  const Eigen::Matrix3Xd points = pointsOf(variables);
  for (std::size_t i = 0; i < selected_.size(); ++i) {
    const Sample& sample = samples_[selected_[i].sample];
    const UprightPrism& obstacle = obstacles_[selected_[i].obstacle];
    const Eigen::Vector3d point = points.middleCols<4>(sample.first) * sample.weights;
    Eigen::Vector2d away;
    const double beside_m = smoothMaximum(gapsBeside_m(selected_[i], point.head<2>()), away);
    const double above_m = point.z() - obstacle.height_m - clearance_m_;
    values[i] = may_lift_ ? -smoothMaximum(beside_m, above_m) : -beside_m;
    if (gradients == nullptr) continue;
    const double share = may_lift_ ? shareOfFirst(beside_m, above_m) : 1;
    const Eigen::Vector3d derivative(-share * away.x(), -share * away.y(), share - 1);
    double* gradient = gradients + static_cast<Eigen::Index>(i) * numVariables();
    std::fill_n(gradient, numVariables(), 0.0);
    for (Eigen::Index k = 0; k < 4; ++k) {
      addTo(gradient, sample.first + k, sample.weights[k] * derivative);
    }
  }
}

}  // namespace conceptplan
