#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "conceptplan/learner/disentanglement/factor_codes.hpp"

namespace conceptplan {

/// How well each token serves one factor only, each factor needs one token only, and all tokens
/// together tell the factors.
struct DciScores {
  double disentanglement = 0;  ///< in [0, 1]
  double completeness = 0;     ///< in [0, 1]
  double informativeness = 0;  ///< share of held-out factor values told right; mean over factors
  Eigen::MatrixXd importance;  ///< [tokens, K], of each token for each factor; columns sum to 1
};

/// Source: Eastwood and Williams, A Framework for the Quantitative Evaluation of Disentangled
/// Representations, ICLR 2018, in its variant with random forests: they need no assumption on how a
/// code shows a factor, which the lasso does (clusters of symbols lie on no line). A factor is told
/// by ten bagged trees from all code dimensions, with the depth (4, 6, 8 or 12) that tells it best
/// on a validation fifth; 60 % of the pictures grow the trees, the last fifth gives the
/// informativeness. A split may use any dimension: drawing a few at random would credit dimensions
/// for the absence of better ones, and perfect codes would not score 1. The importance of a
/// dimension is its share of the decrease of Gini impurity; that of a token the sum over its
/// dimensions. Deterministic for a seed.
/// @throws std::invalid_argument as `checkFactorCodes`
DciScores dciScores(const FactorCodes& data, std::uint64_t seed = 0);

}  // namespace conceptplan
