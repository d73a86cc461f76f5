#pragma once

#include <Eigen/Core>

namespace conceptplan {

/// Spans of a trajectory for each action. With three, a trajectory that stands still after each
/// action is one of the splines: the control points of each stop are its last and the next's first
/// three.
inline constexpr int kSpansPerAction = 3;

/// Weights of the four control points of a span of a uniform cubic B-spline, `share` in [0, 1]
/// through it.
inline Eigen::Vector4d splineWeights(double share) {
  const double rest = 1 - share;
  const double square = share * share;
  const double cube = square * share;
  return Eigen::Vector4d(rest * rest * rest, 3 * cube - 6 * square + 4,
                         -3 * cube + 3 * square + 3 * share + 1, cube) /
         6;
}

}  // namespace conceptplan
