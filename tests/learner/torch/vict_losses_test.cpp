#include "conceptplan/learner/torch/vict_losses.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

TEST(TokenLoss, Eq8TokensAreTheMeanSquaredErrorOfPredictedOnes) {
  auto predicted = torch::zeros({2, 6, 64});
  predicted[1].slice(0, 0, 3).fill_(2);  // a quarter of all numbers is off by 2
  predicted.set_requires_grad(true);
  const auto loss = tokenLoss(predicted, torch::zeros({2, 6, 64}));
  EXPECT_NEAR(loss.item<double>(), 1, 1e-6);
  loss.backward();
  EXPECT_NEAR(predicted.grad()[1][0][0].item<double>(), 2 * 2.0 / (2 * 6 * 64), 1e-8);
}

/// Four windows, all pixels of which are off by 0.1, 0.2, 0.3 and 0.4.
torch::Tensor fourWindows() {
  return torch::tensor({0.1, 0.2, 0.3, 0.4}, torch::kFloat).view({4, 1, 1, 1}).repeat({1, 3, 8, 8});
}

TEST(SynthesisLoss, Eq8WeighsPredictionAndReconstructionByTheirWindowsBesideAbsoluteErrors) {
  const auto frames = fourWindows().set_requires_grad(true);
  const auto loss = synthesisLoss(frames, torch::zeros({4, 3, 8, 8}));
  EXPECT_NEAR(loss.item<double>(), 10 * (0.01 + 0.04 + 0.09 + 0.16) / 4 + 0.25, 1e-6);
  loss.backward();
  const double numbers = 4 * 3 * 8 * 8;
  for (int window = 0; window < 4; ++window)
    EXPECT_NEAR(frames.grad()[window].sum().item<double>() * numbers / (3 * 8 * 8),
                10 * 2 * 0.1 * (window + 1) + 1, 1e-4);
}

TEST(SynthesisErrors, Eq8TellsPredictionAndReconstructionApart) {
  const auto frames = fourWindows(), truth = torch::zeros({4, 3, 8, 8});
  const auto reconstruction = torch::tensor({0, 1, 0, 0}, torch::kFloat).view({4, 1, 1, 1});
  const VictLosses errors = synthesisErrors(frames, truth, reconstruction);
  EXPECT_EQ(errors.tokens, 0);
  EXPECT_NEAR(errors.prediction, (0.01 + 0.09 + 0.16) / 3, 1e-6);
  EXPECT_NEAR(errors.reconstruction, 0.04, 1e-6);
  EXPECT_EQ(synthesisErrors(frames, truth, torch::zeros({4, 1, 1, 1})).reconstruction, 0);
  EXPECT_EQ(synthesisErrors(frames, truth, torch::ones({4, 1, 1, 1})).prediction, 0);
}

}  // namespace
}  // namespace conceptplan
