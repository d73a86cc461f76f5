#include "conceptplan/learner/disentanglement/disentanglement_scores.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "learner/disentanglement/factor_grid.hpp"

namespace conceptplan {
namespace {

constexpr double kChance = 1.0 / 3;  // of the factors

/// Factor 0 shown by two dimensions.
FactorCodes duplicated() {
  FactorCodes data = testing::perfectCodes();
  data.codes.conservativeResize(Eigen::NoChange, 4);
  data.codes.col(3) = 2 * data.codes.col(0);
  return data;
}

/// Factors 0 and 1 shown by one dimension, the freed one is constant.
FactorCodes merged() {
  FactorCodes data = testing::perfectCodes();
  data.codes.col(0) += 4 * data.codes.col(1);  // 12 values, in bins of their own
  data.codes.col(1).setZero();
  return data;
}

TEST(MutualInformationGap, KnownCodes) {
  EXPECT_NEAR(mutualInformationGap(testing::perfectCodes()), 1, 1e-12);
  EXPECT_NEAR(mutualInformationGap(testing::noiseCodes()), 0, 0.02);
  EXPECT_NEAR(mutualInformationGap(duplicated()), 2.0 / 3, 1e-12);
  EXPECT_NEAR(mutualInformationGap(merged()), 1, 1e-12);  // it does not see what else a code shows
}

TEST(MutualInformationGap, ACodeThatTellsPairsOfValuesApart) {
  FactorCodes data = testing::perfectCodes();
  data.codes.col(0) = (data.factors.col(0).array() / 2).cast<double>();  // {0, 1} from {2, 3}
  EXPECT_NEAR(mutualInformationGap(data), (0.5 + 1 + 1) / 3, 1e-12);
}

TEST(SeparatedAttributePredictability, KnownCodes) {
  const double perfect = (3.0 / 4 + 2.0 / 3 + 4.0 / 5) / 3;  // what is left above chance
  EXPECT_NEAR(separatedAttributePredictability(testing::perfectCodes()), perfect, 0.02);
  EXPECT_NEAR(separatedAttributePredictability(testing::noiseCodes()), 0, 0.03);
  EXPECT_NEAR(separatedAttributePredictability(duplicated()), (2.0 / 3 + 4.0 / 5) / 3, 0.02);
}

TEST(SeparatedAttributePredictability, ThresholdsAreTheBestThereAre) {
  // Factor 0 takes its four values three times along twelve ascending codes. Three thresholds tell
  // at best six codes of them right, e.g. 0 up to the last 0, then 1, 2 and 3.
  const FactorCodes data = merged();
  const double factor0 = 0.5, factor1 = 1, factor2 = 1;
  const double chance = 1.0 / 4 + 1.0 / 3 + 1.0 / 5;
  EXPECT_NEAR(separatedAttributePredictability(data), (factor0 + factor1 + factor2 - chance) / 3,
              0.03);
}

TEST(FactorVaeScore, KnownCodes) {
  EXPECT_DOUBLE_EQ(factorVaeScore(testing::perfectCodes()), 1);
  EXPECT_NEAR(factorVaeScore(testing::noiseCodes()), kChance, 0.05);
  EXPECT_DOUBLE_EQ(factorVaeScore(duplicated()), 1);
  // Being the token of least variance tells not which of its two factors a dimension was fixed by.
  EXPECT_LT(factorVaeScore(merged()), 0.95);
}

TEST(BetaVaeScore, KnownCodes) {
  EXPECT_DOUBLE_EQ(betaVaeScore(testing::perfectCodes()), 1);
  EXPECT_NEAR(betaVaeScore(testing::noiseCodes()), kChance, 0.05);
  EXPECT_DOUBLE_EQ(betaVaeScore(duplicated()), 1);
}

TEST(BetaVaeScore, CodesOfNoVarianceTellByChance) {
  FactorCodes data = testing::perfectCodes();
  data.codes.setZero();
  EXPECT_NEAR(betaVaeScore(data), kChance, 0.05);
  EXPECT_DOUBLE_EQ(factorVaeScore(data), kChance);
  EXPECT_DOUBLE_EQ(mutualInformationGap(data), 0);
}

TEST(DisentanglementScores, ClusteredTokensAreScoredByTheirPrincipalComponent) {
  const DisentanglementScores scores = disentanglementScores(testing::clusteredTokens(), 2);
  EXPECT_GT(scores.dci.disentanglement, 0.99);
  EXPECT_GT(scores.mig, 0.8);
  EXPECT_GT(scores.sap, 0.6);
  EXPECT_DOUBLE_EQ(scores.factor_vae, 1);
  EXPECT_DOUBLE_EQ(scores.beta_vae, 1);
}

TEST(DisentanglementScores, OneSeedOneScore) {
  const FactorCodes data = testing::noiseCodes();
  const DisentanglementScores first = disentanglementScores(data, 9);
  const DisentanglementScores second = disentanglementScores(data, 9);
  EXPECT_EQ(first.dci.importance, second.dci.importance);
  EXPECT_EQ(first.sap, second.sap);
  EXPECT_EQ(first.factor_vae, second.factor_vae);
  EXPECT_EQ(first.beta_vae, second.beta_vae);
  EXPECT_NE(first.factor_vae, factorVaeScore(data, 10));
}

}  // namespace
}  // namespace conceptplan
