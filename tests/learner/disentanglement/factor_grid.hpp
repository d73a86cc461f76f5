#pragma once

#include <random>

#include "conceptplan/learner/disentanglement/factor_codes.hpp"

namespace conceptplan::testing {

/// Every combination of three factors with 4, 3 and 5 values, forty times each: [2400, 3].
inline Eigen::MatrixXi factorGrid() {
  Eigen::MatrixXi factors(2400, 3);
  for (int i = 0; i < 2400; ++i) factors.row(i) << i % 4, i / 4 % 3, i / 12 % 5;
  return factors;
}

inline Eigen::MatrixXd noise(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

/// A code dimension for each factor, which is its value.
inline FactorCodes perfectCodes() { return {factorGrid().cast<double>(), factorGrid(), {}}; }

inline FactorCodes noiseCodes() { return {noise(2400, 3, 7), factorGrid(), {}}; }

/// Three tokens of eight dimensions; token k holds a random vector for each value of factor k, with
/// a little noise: clusters as a concept learner makes them.
inline FactorCodes clusteredTokens() {
  FactorCodes data{0.05 * noise(2400, 24, 3), factorGrid(), {}};
  for (int token = 0; token < 3; ++token) {
    const Eigen::MatrixXd centers = noise(5, 8, 11 + static_cast<std::uint64_t>(token));
    for (Eigen::Index i = 0; i < 2400; ++i)
      data.codes.row(i).segment<8>(8 * token) += centers.row(data.factors(i, token));
    data.token.insert(data.token.end(), 8, token);
  }
  return data;
}

}  // namespace conceptplan::testing
