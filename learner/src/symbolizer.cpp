#include "conceptplan/learner/symbolizer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

/// exp(-distance / temperature), normalised.
Eigen::VectorXd probabilities(const Eigen::VectorXd& distances, double temperature) {
  Eigen::VectorXd weights = (-(distances.array() - distances.minCoeff()) / temperature).exp();
  return weights / weights.sum();
}

void checkSizes(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right) {
  if (distances.rows() == 0 || distances.rows() != static_cast<Eigen::Index>(right.size()))
    throw std::invalid_argument("calibration: " + std::to_string(distances.rows()) +
                                " rows of distances for " + std::to_string(right.size()) +
                                " right symbols");
}

double negativeLogLikelihood(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right,
                             double temperature) {
  double total = 0;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    const Eigen::VectorXd p = probabilities(distances.row(i), temperature);
    total -= std::log(
        std::max(1e-12, p[static_cast<Eigen::Index>(index(right[static_cast<std::size_t>(i)]))]));
  }
  return total;
}

}  // namespace

Symbolizer::Symbolizer(std::array<SymbolClusters, kNumConcepts> clusters)
    : clusters_(std::move(clusters)) {
  for (const Concept which : kConcepts) {
    const SymbolClusters& of_concept = clusters_[index(which)];
    if (of_concept.centers.rows() == 0 || !(of_concept.temperature > 0) ||
        !std::isfinite(of_concept.temperature) || !(of_concept.reach > 0) ||
        !of_concept.centers.allFinite())
      throw std::invalid_argument("Symbolizer: " + std::string(name(which)) + " has " +
                                  std::to_string(of_concept.centers.rows()) +
                                  " centres, temperature " +
                                  std::to_string(of_concept.temperature) + " and reach " +
                                  std::to_string(of_concept.reach));
  }
}

std::array<std::size_t, kNumConcepts> Symbolizer::cardinality() const {
  std::array<std::size_t, kNumConcepts> counts{};
  for (std::size_t k = 0; k < kNumConcepts; ++k)
    counts[k] = static_cast<std::size_t>(clusters_[k].centers.rows());
  return counts;
}

SymbolBelief Symbolizer::belief(const Tokens& tokens) const {
  SymbolBelief belief;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    const Eigen::VectorXd p =
        probabilities(squaredDistances(clusters_[k], tokens.row(static_cast<Eigen::Index>(k))),
                      clusters_[k].temperature);
    belief[k].assign(p.begin(), p.end());
  }
  return belief;
}

Symbols Symbolizer::nearest(const Tokens& tokens) const {
  Symbols symbols{};
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    Eigen::Index nearest = 0;
    squaredDistances(clusters_[k], tokens.row(static_cast<Eigen::Index>(k))).minCoeff(&nearest);
    symbols[k] = SymbolId{static_cast<std::int32_t>(nearest)};
  }
  return symbols;
}

std::array<bool, kNumConcepts> Symbolizer::fits(const Tokens& tokens) const {
  std::array<bool, kNumConcepts> fits{};
  for (std::size_t k = 0; k < kNumConcepts; ++k)
    fits[k] = squaredDistances(clusters_[k], tokens.row(static_cast<Eigen::Index>(k))).minCoeff() <=
              clusters_[k].reach;
  return fits;
}

Eigen::VectorXd squaredDistances(const SymbolClusters& clusters,
                                 const Eigen::Ref<const Eigen::RowVectorXf>& token) {
  return (clusters.centers.rowwise() - token).rowwise().squaredNorm().cast<double>();
}

double fitTemperature(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right) {
  checkSizes(distances, right);
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double low = std::log(1e-2), high = std::log(1e3);
  const auto loss = [&](double log_temperature) {
    return negativeLogLikelihood(distances, right, std::exp(log_temperature));
  };
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double loss_a = loss(a), loss_b = loss(b);
  while (high - low > 1e-3) {
    if (loss_a < loss_b) {
      high = b, b = a, loss_b = loss_a;
      a = high - golden * (high - low), loss_a = loss(a);
    } else {
      low = a, a = b, loss_a = loss_b;
      b = low + golden * (high - low), loss_b = loss(b);
    }
  }
  return std::exp(0.5 * (low + high));
}

double quantile(Eigen::VectorXd values, double share) {
  if (values.size() == 0) throw std::invalid_argument("quantile: no values");
  std::sort(values.begin(), values.end());
  const double last = static_cast<double>(values.size() - 1);
  return values[static_cast<Eigen::Index>(std::ceil(share * last))];
}

double calibrationError(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right,
                        double temperature) {
  checkSizes(distances, right);
  std::vector<double> confidence;
  std::vector<bool> correct;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    Eigen::Index best = 0;
    confidence.push_back(probabilities(distances.row(i), temperature).maxCoeff(&best));
    correct.push_back(static_cast<std::size_t>(best) == index(right[static_cast<std::size_t>(i)]));
  }
  return calibrationError(confidence, correct);
}

Calibration calibrate(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right,
                      double share) {
  checkSizes(distances, right);
  std::array<std::vector<Eigen::Index>, 2> rows;  // of even and of odd number
  std::array<std::vector<SymbolId>, 2> symbols;
  for (std::size_t i = 0; i < right.size(); ++i) {
    rows[i % 2].push_back(static_cast<Eigen::Index>(i));
    symbols[i % 2].push_back(right[i]);
  }
  const double temperature = fitTemperature(distances(rows[0], Eigen::all), symbols[0]);
  return {temperature, quantile(distances.rowwise().minCoeff(), share),
          calibrationError(distances(rows[1], Eigen::all), symbols[1], temperature)};
}

double calibrationError(const std::vector<double>& confidence, const std::vector<bool>& right) {
  if (confidence.empty() || confidence.size() != right.size())
    throw std::invalid_argument("calibration: " + std::to_string(confidence.size()) +
                                " confidences of " + std::to_string(right.size()) + " answers");
  constexpr std::size_t kBins = 10;
  std::array<double, kBins> excess{};  // confidence less what was right, summed
  for (std::size_t i = 0; i < right.size(); ++i)
    excess[std::min(kBins - 1, static_cast<std::size_t>(confidence[i] * kBins))] +=
        confidence[i] - (right[i] ? 1 : 0);
  double error = 0;
  for (const double of_bin : excess) error += std::abs(of_bin);
  return error / static_cast<double>(right.size());
}

}  // namespace conceptplan
