#include <algorithm>
#include <cmath>

#include "conceptplan/learner/disentanglement/disentanglement_scores.hpp"

namespace conceptplan {
namespace {

constexpr int kBins = 20;

/// Bins of equal width between the least and the largest code, in [0, 20).
Eigen::VectorXi equalWidthBins(const Eigen::VectorXd& codes) {
  const double low = codes.minCoeff(), width = codes.maxCoeff() - low;
  if (!(width > 0)) return Eigen::VectorXi::Zero(codes.size());
  return codes.unaryExpr([&](double code) {
    return std::min(kBins - 1, static_cast<int>((code - low) / width * kBins));
  });
}

/// Entropy of a table of counts, nats.
double entropy(const Eigen::MatrixXd& counts) {
  const double total = counts.sum();
  double sum = 0;
  for (const double count : counts.reshaped())
    if (count > 0) sum -= count / total * std::log(count / total);
  return sum;
}

}  // namespace

double mutualInformationGap(const FactorCodes& data) {
  checkFactorCodes(data);
  const Eigen::MatrixXd codes = principalCodes(data);
  double gaps = 0;
  for (Eigen::Index k = 0; k < data.factors.cols(); ++k) {
    double best = 0, second = 0, factor_entropy = 0;
    for (Eigen::Index token = 0; token < codes.cols(); ++token) {
      const Eigen::VectorXi bins = equalWidthBins(codes.col(token));
      Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(kBins, data.numValues(k));
      for (Eigen::Index i = 0; i < bins.size(); ++i) counts(bins[i], data.factors(i, k)) += 1;
      factor_entropy = entropy(counts.colwise().sum());
      const double information = entropy(counts.rowwise().sum()) + factor_entropy - entropy(counts);
      second = std::max(second, std::min(best, information));
      best = std::max(best, information);
    }
    gaps += (best - second) / factor_entropy;
  }
  return gaps / static_cast<double>(data.factors.cols());
}

}  // namespace conceptplan
