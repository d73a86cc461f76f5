#pragma once

#include <Eigen/Core>

namespace conceptplan {

/// The directions in which points vary most.
struct PrincipalAxes {
  Eigen::MatrixXd axes;  ///< [dimensions, count]: unit columns, the widest first; the component
                         ///< that is largest by magnitude is positive
  double share = 0;      ///< of the variance, along those axes
};

/// Principal component analysis. points [n, dimensions]; count in 1..dimensions.
PrincipalAxes principalAxes(Eigen::MatrixXd points, Eigen::Index count);

}  // namespace conceptplan
