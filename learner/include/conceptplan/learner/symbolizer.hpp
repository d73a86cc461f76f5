#pragma once

#include <array>
#include <limits>

#include "conceptplan/domain/symbols.hpp"
#include "conceptplan/learner/tokens.hpp"

namespace conceptplan {

/// The symbols of one concept: cluster centres of its tokens.
struct SymbolClusters {
  TokenMatrix centers;     ///< [symbols, 64]
  double temperature = 1;  ///< > 0; squared distance at which a centre is e times less probable
  /// > 0; a token whose squared distance to every centre is larger fits no symbol.
  double reach = std::numeric_limits<double>::infinity();
};

/// Makes symbols of tokens. Source: sigma in Sec. III-B of arXiv 2310.03325; the probabilities are
/// ours: a softmax of minus the squared distance to the centres over the temperature.
/// Immutable; threads may share it.
class Symbolizer {
 public:
  /// @throws std::invalid_argument if a concept has no centre, a temperature or reach is not
  /// positive, or a centre or temperature is not finite.
  explicit Symbolizer(std::array<SymbolClusters, kNumConcepts> clusters);

  std::array<std::size_t, kNumConcepts> cardinality() const;
  const SymbolClusters& clusters(Concept which) const { return clusters_[index(which)]; }

  /// How probable each symbol is, for each concept.
  SymbolBelief belief(const Tokens& tokens) const;

  /// The symbol of the nearest centre, for each concept.
  Symbols nearest(const Tokens& tokens) const;

  /// Whether the token of each concept lies within reach of a centre; else the object shows
  /// something that was never learned, and its symbol is a guess.
  std::array<bool, kNumConcepts> fits(const Tokens& tokens) const;

 private:
  std::array<SymbolClusters, kNumConcepts> clusters_;
};

/// Squared distances of a token to the centres, [symbols].
Eigen::VectorXd squaredDistances(const SymbolClusters& clusters,
                                 const Eigen::Ref<const Eigen::RowVectorXf>& token);

/// The temperature with the least negative log likelihood of the right symbols, by golden-section
/// search on its logarithm. distances [N, symbols]; right [N].
/// @throws std::invalid_argument if there are no rows or sizes differ.
double fitTemperature(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right);

/// The value at that share, in [0, 1], of the way from the least to the greatest, in order; of two
/// the greater. @throws std::invalid_argument if there are none.
double quantile(Eigen::VectorXd values, double share);

/// Expected calibration error over ten bins of confidence, in [0, 1].
/// Source: Guo et al., ICML 2017. Arguments as `fitTemperature`.
double calibrationError(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right,
                        double temperature);

/// What validation says of a concept's clusters.
struct Calibration {
  double temperature = 1;
  double reach = 0;
  double error = 0;  ///< expected calibration error
};

/// Fits the temperature on the rows of even number, and takes the error on those of odd number,
/// which it has not seen; the reach holds a share of the nearest distances of all. Arguments as
/// `fitTemperature`. @throws std::invalid_argument for less than two rows, or if sizes differ.
Calibration calibrate(const Eigen::MatrixXd& distances, const std::vector<SymbolId>& right,
                      double share);

/// Expected calibration error from the probability of each answer given, and whether it was right.
/// @throws std::invalid_argument if there are none or sizes differ.
double calibrationError(const std::vector<double>& confidence, const std::vector<bool>& right);

}  // namespace conceptplan
