#include "conceptplan/learner/symbolizer.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <random>

namespace conceptplan {
namespace {

std::array<SymbolClusters, kNumConcepts> cornerClusters(double temperature) {
  std::array<SymbolClusters, kNumConcepts> clusters;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    const auto count = static_cast<Eigen::Index>(kConceptCardinality[k]);
    clusters[k].centers = TokenMatrix::Zero(count, 64);
    for (Eigen::Index s = 0; s < count; ++s) clusters[k].centers(s, s) = 3;
    clusters[k].temperature = temperature;
  }
  return clusters;
}

TEST(Symbolizer, TakesTheNearestCentre) {
  const Symbolizer symbolizer(cornerClusters(1));
  Tokens tokens = Tokens::Zero();
  for (Eigen::Index k = 0; k < 6; ++k) tokens(k, 2) = 2.5F;
  const Symbols symbols = symbolizer.nearest(tokens);
  for (const SymbolId symbol : symbols) EXPECT_EQ(symbol, SymbolId{2});
  EXPECT_EQ(mostProbable(symbolizer.belief(tokens)), symbols);
}

TEST(Symbolizer, BeliefIsASoftmaxOfSquaredDistances) {
  const Symbolizer symbolizer(cornerClusters(4));
  Tokens tokens = Tokens::Zero();
  tokens(1, 0) = 1;  // POSITION_X: squared distances 4, 10, 10
  const auto belief = symbolizer.belief(tokens)[index(Concept::kPositionX)];
  EXPECT_NEAR(belief[0], 1 / (1 + 2 * std::exp(-6.0 / 4)), 1e-6);
  EXPECT_NEAR(std::accumulate(belief.begin(), belief.end(), 0.0), 1, 1e-12);
}

TEST(Symbolizer, TellsATokenThatFitsNoSymbol) {
  auto clusters = cornerClusters(1);
  for (auto& of_concept : clusters) of_concept.reach = 4;
  const Symbolizer symbolizer(clusters);
  Tokens tokens = Tokens::Zero();
  for (Eigen::Index k = 0; k < 6; ++k) tokens(k, 0) = 3;
  tokens(2, 0) = 0.9F;  // 2.1 from its centre
  const auto fits = symbolizer.fits(tokens);
  for (std::size_t k = 0; k < kNumConcepts; ++k) EXPECT_EQ(fits[k], k != 2);
  EXPECT_EQ(symbolizer.nearest(tokens)[2], SymbolId{0});
}

TEST(Calibration, QuantileIsTheValueAtItsShareOfTheOrder) {
  Eigen::VectorXd values(5);
  values << 1, 2, 5, 4, 3;
  EXPECT_EQ(quantile(values, 1), 5);
  EXPECT_EQ(quantile(values, 0.5), 3);
  EXPECT_EQ(quantile(values, 0.6), 4);  // between two: the greater
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_THROW(quantile(Eigen::VectorXd(0), 0.5), std::invalid_argument);
}

TEST(Symbolizer, RefusesNoCentresAndBadTemperatures) {
  auto clusters = cornerClusters(1);
  clusters[0].temperature = 0;
  EXPECT_THAT([&] { Symbolizer{clusters}; },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("TYPE")));
}

/// Distances whose right symbol is drawn from the softmax at the temperature.
void drawCalibrated(double temperature, Eigen::MatrixXd& distances, std::vector<SymbolId>& right) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  distances.resize(4000, 3);
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    for (Eigen::Index s = 0; s < 3; ++s) distances(i, s) = 10 * uniform(generator);
    Eigen::ArrayXd p = (-distances.row(i).transpose().array() / temperature).exp();
    p /= p.sum();
    double draw = uniform(generator);
    int symbol = 0;
    while (symbol < 2 && (draw -= p[symbol]) > 0) ++symbol;
    right.push_back(SymbolId{symbol});
  }
}

TEST(Calibration, FindsTheTemperatureThatMadeTheData) {
  Eigen::MatrixXd distances;
  std::vector<SymbolId> right;
  drawCalibrated(2.5, distances, right);
  EXPECT_NEAR(fitTemperature(distances, right), 2.5, 0.2);
}

TEST(Calibration, ErrorIsSmallAtTheRightTemperatureAndLargeAtAWrongOne) {
  Eigen::MatrixXd distances;
  std::vector<SymbolId> right;
  drawCalibrated(2.5, distances, right);
  EXPECT_LT(calibrationError(distances, right, 2.5), 0.03);
  EXPECT_GT(calibrationError(distances, right, 0.25), 0.1);
  EXPECT_THROW(calibrationError(distances, {}, 1), std::invalid_argument);
}

TEST(Calibration, FitsOnOneHalfAndTakesTheErrorOnTheOther) {
  // Even rows are right, odd ones wrong, at distances that are equal but for one far row of each.
  Eigen::MatrixXd distances(8, 2);
  for (Eigen::Index i = 0; i < 8; ++i)
    distances.row(i) << (i < 2 ? 4.0 + static_cast<double>(i) : 1.0), 9;
  const std::vector<SymbolId> right{SymbolId{0}, SymbolId{1}, SymbolId{0}, SymbolId{1},
                                    SymbolId{0}, SymbolId{1}, SymbolId{0}, SymbolId{1}};
  const Calibration calibration = calibrate(distances, right, 1);
  EXPECT_LT(calibration.temperature, 0.5);  // as sure as can be
  EXPECT_EQ(calibration.reach, 5);
  EXPECT_GT(calibration.error, 0.99);
  EXPECT_THROW(calibrate(distances.topRows(1), {SymbolId{0}}, 1), std::invalid_argument);
  EXPECT_THROW(calibrate(distances, {SymbolId{0}}, 1), std::invalid_argument);
}

TEST(Calibration, ErrorIsTheGapBetweenConfidenceAndWhatWasRight) {
  // Two answers in the highest bin, half right: |1.9 - 1|; two in the sixth: |1.1 - 1|.
  EXPECT_NEAR(calibrationError({0.95, 0.95, 0.55, 0.55}, {true, false, true, false}),
              (0.9 + 0.1) / 4, 1e-12);
  EXPECT_DOUBLE_EQ(calibrationError({1, 1}, {true, true}), 0);
  EXPECT_THROW(calibrationError({0.5}, {true, false}), std::invalid_argument);
  EXPECT_THROW(calibrationError(std::vector<double>{}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
