#pragma once

#include <Eigen/Core>

namespace conceptplan {

/// The directions in which points vary most, by principal component analysis, [dimensions, count]:
/// unit columns, the widest first; of each the component that is largest by magnitude is positive.
/// points [n, dimensions]; count in 1..dimensions.
Eigen::MatrixXd principalAxes(Eigen::MatrixXd points, Eigen::Index count);

}  // namespace conceptplan
