#include "conceptplan/learner/disentanglement/dci.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "learner/disentanglement/factor_grid.hpp"

namespace conceptplan {
namespace {

TEST(Dci, PerfectCodesScoreOne) {
  const DciScores scores = dciScores(testing::perfectCodes());
  EXPECT_DOUBLE_EQ(scores.disentanglement, 1);
  EXPECT_DOUBLE_EQ(scores.completeness, 1);
  EXPECT_DOUBLE_EQ(scores.informativeness, 1);
  EXPECT_EQ(scores.importance, Eigen::MatrixXd(Eigen::Matrix3d::Identity()));
}

TEST(Dci, NoiseTellsNothing) {
  const DciScores scores = dciScores(testing::noiseCodes());
  EXPECT_LT(scores.disentanglement, 0.02);
  EXPECT_LT(scores.completeness, 0.02);
  EXPECT_NEAR(scores.informativeness, (1.0 / 4 + 1.0 / 3 + 1.0 / 5) / 3, 0.05);
}

TEST(Dci, ARotationEntanglesWhatItMixes) {
  FactorCodes data = testing::perfectCodes();
  Eigen::Matrix3d mixing;
  mixing << 2, 1, 1, 1, 2, -1, -1, 1, 2;  // every dimension shows every factor
  data.codes = data.codes * mixing;
  const DciScores scores = dciScores(data);
  EXPECT_LT(scores.disentanglement, 0.35);
  EXPECT_LT(scores.completeness, 0.35);
}

TEST(Dci, ADimensionTwiceCostsCompletenessAlone) {
  FactorCodes data = testing::perfectCodes();
  data.codes.conservativeResize(Eigen::NoChange, 4);
  data.codes.col(3) = data.codes.col(0);
  const DciScores scores = dciScores(data);
  EXPECT_DOUBLE_EQ(scores.disentanglement, 1);
  // Factor 0 is shared by two of four dimensions, evenly but for chance: 1 - log 2 / log 4.
  EXPECT_NEAR(scores.completeness, (0.5 + 1 + 1) / 3, 0.02);
}

TEST(Dci, ADimensionForTwoFactorsCostsDisentanglementAlone) {
  FactorCodes data = testing::perfectCodes();
  data.codes.col(0) += 10 * data.codes.col(1);
  data.codes.col(1) = testing::noise(2400, 1, 5);
  const DciScores scores = dciScores(data);
  // Two thirds of all importance is of a dimension that serves two of three factors evenly.
  EXPECT_NEAR(scores.disentanglement, 2.0 / 3 * (1 - std::log(2) / std::log(3)) + 1.0 / 3, 0.02);
  EXPECT_NEAR(scores.completeness, 1, 0.05);
  EXPECT_DOUBLE_EQ(scores.informativeness, 1);
}

TEST(Dci, ImportanceIsSummedWithinTokens) {
  const FactorCodes tokens = testing::clusteredTokens();
  const DciScores scores = dciScores(tokens);
  EXPECT_GT(scores.disentanglement, 0.99);
  EXPECT_GT(scores.completeness, 0.99);
  EXPECT_EQ(scores.importance.rows(), 3);
  FactorCodes dimensions = tokens;
  dimensions.token.clear();
  // Each factor is spread over eight dimensions, none of which serves another factor.
  const DciScores alone = dciScores(dimensions);
  EXPECT_GT(alone.disentanglement, 0.99);
  EXPECT_LT(alone.completeness, 0.75);
}

TEST(Dci, OneSeedOneScore) {
  EXPECT_EQ(dciScores(testing::noiseCodes(), 4).importance,
            dciScores(testing::noiseCodes(), 4).importance);
  EXPECT_NE(dciScores(testing::noiseCodes(), 4).importance,
            dciScores(testing::noiseCodes(), 5).importance);
}

}  // namespace
}  // namespace conceptplan
