#include "conceptplan/learner/disentanglement/dci.hpp"

#include <array>
#include <cmath>

#include "disentanglement/random_forest.hpp"
#include "disentanglement/shuffled_rows.hpp"

namespace conceptplan {
namespace {

constexpr std::array kDepths{4, 6, 8, 12};

/// 1 less the entropy of shares to the base of their number; 0 if there is nothing to share.
double concentration(const Eigen::VectorXd& shares) {
  const double total = shares.sum();
  if (!(total > 0)) return 0;
  double entropy = 0;
  for (const double share : shares)
    if (share > 0) entropy -= share / total * std::log(share / total);
  return 1 - entropy / std::log(static_cast<double>(shares.size()));
}

/// Mean of `concentration` over the columns, each weighed by its sum.
double weightedConcentration(const Eigen::MatrixXd& columns) {
  double sum = 0;
  for (Eigen::Index c = 0; c < columns.cols(); ++c)
    sum += columns.col(c).sum() * concentration(columns.col(c));
  return columns.sum() > 0 ? sum / columns.sum() : 0;
}

double accuracy(const RandomForest& forest, const QuantileBins& bins, const Eigen::VectorXi& labels,
                const std::vector<Eigen::Index>& rows, int depth) {
  double right = 0;
  for (const Eigen::Index row : rows) right += forest.predict(bins, row, depth) == labels[row];
  return right / static_cast<double>(rows.size());
}

}  // namespace

DciScores dciScores(const FactorCodes& data, std::uint64_t seed) {
  checkFactorCodes(data);
  std::mt19937_64 generator(seed);
  const QuantileBins bins = quantileBins(data.codes);
  const std::vector<Eigen::Index> rows = shuffledRows(data.codes.rows(), generator);
  const auto fifth = static_cast<std::ptrdiff_t>(rows.size() / 5);
  const std::vector<Eigen::Index> test(rows.begin(), rows.begin() + fifth);
  const std::vector<Eigen::Index> validation(rows.begin() + fifth, rows.begin() + 2 * fifth);
  const std::vector<Eigen::Index> train(rows.begin() + 2 * fifth, rows.end());

  DciScores scores;
  const Eigen::Index factors = data.factors.cols();
  scores.importance = Eigen::MatrixXd::Zero(data.numTokens(), factors);
  for (Eigen::Index k = 0; k < factors; ++k) {
    const Eigen::VectorXi labels = data.factors.col(k);
    const RandomForest forest(bins, labels, data.numValues(k), train, generator);
    int depth = kDepths.front();
    double best = -1;
    for (const int candidate : kDepths) {
      const double found = accuracy(forest, bins, labels, validation, candidate);
      if (found > best) best = found, depth = candidate;
    }
    scores.informativeness += accuracy(forest, bins, labels, test, depth) / factors;
    const Eigen::VectorXd importance = forest.importance(depth);
    for (Eigen::Index d = 0; d < importance.size(); ++d)
      scores.importance(data.token.empty() ? d : data.token[static_cast<std::size_t>(d)], k) +=
          importance[d];
  }
  scores.disentanglement = weightedConcentration(scores.importance.transpose());
  scores.completeness = weightedConcentration(scores.importance);
  return scores;
}

}  // namespace conceptplan
