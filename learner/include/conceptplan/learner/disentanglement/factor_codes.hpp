#pragma once

#include <Eigen/Core>
#include <vector>

namespace conceptplan {

/// Codes of N pictures and the factors that made the pictures: what disentanglement is measured on.
struct FactorCodes {
  Eigen::MatrixXd codes;    ///< [N, D]
  Eigen::MatrixXi factors;  ///< [N, K], the value of each factor, from 0
  /// [D], the token that each code dimension belongs to, from 0 without gaps; empty if each
  /// dimension stands for itself.
  std::vector<int> token;

  Eigen::Index numTokens() const;
  /// One more than the largest value of a factor.
  int numValues(Eigen::Index factor) const { return factors.col(factor).maxCoeff() + 1; }
};

/// @throws std::invalid_argument unless there are at least ten pictures, two tokens and two
/// factors, rows and sizes agree, codes are finite, and each factor shows at least two values.
void checkFactorCodes(const FactorCodes& data);

/// The codes with one number a token, [N, tokens]: its coordinate along the first principal
/// component of the token's own dimensions, the largest weight positive. Tokens of one dimension
/// stay as they are. So vector-valued concepts are scored where a measure is defined for scalars;
/// source: "Evaluation" in Yang et al., Visual Concepts Tokenization, arXiv 2205.10093.
Eigen::MatrixXd principalCodes(const FactorCodes& data);

}  // namespace conceptplan
