#include "conceptplan/learner/torch/concept_losses.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace conceptplan {
namespace {

TEST(ReconstructionLoss, Eq1IsTheWeightedSquaredErrorWithDepthAndTheMasksCrossEntropy) {
  auto planes = torch::zeros({1, 5, 64, 64});
  planes.slice(1, 4, 5).slice(2, 0, 32).fill_(1);  // the upper half is the object
  auto drawn = torch::zeros({1, 3, 64, 64});
  drawn.slice(2, 0, 32).fill_(0.5);
  const auto logits = torch::zeros({1, 1, 64, 64});
  // Depth is off by 0.2 everywhere, and counts on the object alone.
  const auto depth = torch::full({1, 1, 64, 64}, 0.2);
  // Half of the pixels weigh 3, the others 1: (3 * 0.25 + 0) / 4, and a tenth of log 2.
  const double expected = 3 * 0.25 / 4 + 0.2 * 0.2 + 0.1 * std::log(2.0);
  EXPECT_NEAR(reconstructionLoss({drawn, logits, depth}, planes, 3).item<double>(), expected, 1e-5);
}

TEST(ConceptDisentanglingLoss, Eq2IsTheCrossEntropyOfTokenDistances) {
  const auto first = torch::zeros({1, 6, 64});
  auto second = torch::zeros({1, 6, 64});
  second[0][2].fill_(0.25);   // distance 2
  second[0][4].fill_(0.125);  // distance 1
  const double sum = std::exp(2.0) + std::exp(1.0) + 4 * std::exp(1e-3);
  EXPECT_NEAR(conceptDisentanglingLoss(first, second, torch::tensor({2L})).item<double>(),
              -std::log(std::exp(2.0) / sum), 1e-3);
  EXPECT_NEAR(conceptDisentanglingLoss(first, second, torch::tensor({4L})).item<double>(),
              -std::log(std::exp(1.0) / sum), 1e-3);
}

TEST(PairLikelihoodLoss, IsZeroForRightOneHotValuesAndLargeForMergedOnes) {
  auto right = torch::zeros({2, 7, 3});
  right.select(2, 0).fill_(1);
  auto merged = right.clone();
  right[0][4][0] = 0;  // image 4 of group 0 shows another value
  right[0][4][1] = 1;
  const auto odd = torch::tensor({true, false});
  EXPECT_NEAR(pairLikelihoodLoss(right, odd, 4).item<double>(), 0, 1e-3);
  EXPECT_GT(pairLikelihoodLoss(merged, odd, 4).item<double>(), 5);
}

TEST(PairLikelihoodLoss, AveragesPairsThatAgreeAndPairsThatDifferApart) {
  const auto even = torch::full({1, 7, 2}, 0.5);
  EXPECT_NEAR(pairLikelihoodLoss(even, torch::tensor({true}), 1).item<double>(), 2 * std::log(2.0),
              1e-4);
  EXPECT_NEAR(pairLikelihoodLoss(even, torch::tensor({false}), 1).item<double>(), std::log(2.0),
              1e-4);
}

TEST(PrototypeUseLoss, IsZeroForEvenUseAndLogNForOnePrototype) {
  EXPECT_NEAR(prototypeUseLoss(torch::full({5, 4}, 0.25)).item<double>(), 0, 1e-5);
  auto one = torch::zeros({5, 4});
  one.select(1, 2).fill_(1);
  EXPECT_NEAR(prototypeUseLoss(one).item<double>(), std::log(4.0), 1e-3);
}

TEST(PrototypeEntropy, IsZeroForOneHotAndLogNForEvenValues) {
  EXPECT_NEAR(prototypeEntropy(torch::full({5, 4}, 0.25)).item<double>(), std::log(4.0), 1e-5);
  EXPECT_NEAR(prototypeEntropy(torch::eye(4)).item<double>(), 0, 1e-5);
}

}  // namespace
}  // namespace conceptplan
