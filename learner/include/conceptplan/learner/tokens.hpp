#pragma once

#include <Eigen/Core>

#include "conceptplan/domain/concept.hpp"

namespace conceptplan {

/// The six concept tokens of one object, a row each, in the order of `Concept`: [6, 64].
using Tokens = Eigen::Matrix<float, static_cast<int>(kNumConcepts), 64, Eigen::RowMajor>;

/// Tokens of one concept, a row each: [N, 64].
using TokenMatrix = Eigen::Matrix<float, Eigen::Dynamic, 64, Eigen::RowMajor>;

}  // namespace conceptplan
