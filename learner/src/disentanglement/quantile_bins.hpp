#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace conceptplan {

inline constexpr int kQuantileBins = 256;

/// Codes by rank: each dimension cut into up to 256 bins of about as many pictures, ascending;
/// equal codes share a bin. Column-major [N, D].
using QuantileBins = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>;
QuantileBins quantileBins(const Eigen::MatrixXd& codes);

}  // namespace conceptplan
