#include <algorithm>
#include <limits>
#include <random>
#include <span>

#include "conceptplan/learner/disentanglement/disentanglement_scores.hpp"
#include "disentanglement/quantile_bins.hpp"
#include "disentanglement/shuffled_rows.hpp"

namespace conceptplan {
namespace {

using Rows = std::span<const Eigen::Index>;

/// Share that each picture of a bin and value has in the balanced accuracy: [values, bins], the sum
/// of each row of values that occur is one over their number.
Eigen::MatrixXd balancedWeights(const QuantileBins& bins, Eigen::Index token,
                                const Eigen::VectorXi& factor, int values, Rows rows) {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(values, kQuantileBins);
  for (const Eigen::Index row : rows) weights(factor[row], bins(row, token)) += 1;
  const Eigen::VectorXd sums = weights.rowwise().sum();
  const auto present = static_cast<double>((sums.array() > 0).count());
  for (Eigen::Index value = 0; value < values; ++value)
    if (sums[value] > 0) weights.row(value) /= sums[value] * present;
  return weights;
}

/// The value told for each bin by as many intervals as there are values, with the largest sum of
/// weights: dynamic programming over (intervals so far, value of the last one).
Eigen::VectorXi bestIntervals(const Eigen::MatrixXd& weights) {
  const Eigen::Index values = weights.rows(), bins = weights.cols();
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Constant(values, values, kNever);  // [intervals, value]
  sum.row(0).setZero();
  // The value before, if an interval begins at the bin; else -1.
  std::vector<Eigen::MatrixXi> before(static_cast<std::size_t>(bins),
                                      Eigen::MatrixXi::Constant(values, values, -1));
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    for (Eigen::Index m = values - 1; bin > 0 && m > 0; --m) {
      Eigen::Index previous = 0;
      const double best = sum.row(m - 1).maxCoeff(&previous);
      for (Eigen::Index value = 0; value < values; ++value)
        if (best > sum(m, value)) {
          sum(m, value) = best;
          before[static_cast<std::size_t>(bin)](m, value) = static_cast<int>(previous);
        }
    }
    sum.rowwise() += weights.col(bin).transpose();
  }
  Eigen::Index intervals = 0, value = 0;
  sum.maxCoeff(&intervals, &value);
  Eigen::VectorXi told(bins);
  for (Eigen::Index bin = bins - 1; bin >= 0; --bin) {
    told[bin] = static_cast<int>(value);
    const int previous = before[static_cast<std::size_t>(bin)](intervals, value);
    if (previous >= 0) value = previous, --intervals;
  }
  return told;
}

}  // namespace

double separatedAttributePredictability(const FactorCodes& data, std::uint64_t seed) {
  checkFactorCodes(data);
  std::mt19937_64 generator(seed);
  const std::vector<Eigen::Index> rows = shuffledRows(data.codes.rows(), generator);
  const Rows train = Rows(rows).first(rows.size() / 2), test = Rows(rows).subspan(rows.size() / 2);
  const QuantileBins bins = quantileBins(principalCodes(data));
  double gaps = 0;
  for (Eigen::Index k = 0; k < data.factors.cols(); ++k) {
    const int values = data.numValues(k);
    double best = 0, second = 0;
    for (Eigen::Index token = 0; token < bins.cols(); ++token) {
      const Eigen::VectorXi told =
          bestIntervals(balancedWeights(bins, token, data.factors.col(k), values, train));
      const Eigen::MatrixXd weights =
          balancedWeights(bins, token, data.factors.col(k), values, test);
      double accuracy = 0;
      for (Eigen::Index bin = 0; bin < told.size(); ++bin) accuracy += weights(told[bin], bin);
      second = std::max(second, std::min(best, accuracy));
      best = std::max(best, accuracy);
    }
    gaps += best - second;
  }
  return gaps / static_cast<double>(data.factors.cols());
}

}  // namespace conceptplan
