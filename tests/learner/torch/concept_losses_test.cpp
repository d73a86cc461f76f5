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

TEST(PairReconstructionLoss, Eq1AddsTheErrorOfTheSubstitutedPictureToThatOfTheFirst) {
  const auto planes = torch::zeros({2, 5, 8, 8});
  auto rgb = torch::zeros({2, 3, 8, 8});
  rgb[0].fill_(0.5);  // drawn from its own tokens
  rgb[1].fill_(0.2);  // drawn after one was substituted
  rgb.set_requires_grad(true);
  const auto no_mask = torch::full({2, 1, 8, 8}, -100.0), no_depth = torch::zeros({2, 1, 8, 8});
  const auto loss = pairReconstructionLoss({rgb, no_mask, no_depth}, planes, 1);
  EXPECT_NEAR(loss.item<double>(), 0.5 * 0.5 + 0.2 * 0.2, 1e-6);
  loss.backward();
  EXPECT_NEAR(rgb.grad()[0].sum().item<double>(), 2 * 0.5, 1e-5);
  EXPECT_NEAR(rgb.grad()[1].sum().item<double>(), 2 * 0.2, 1e-5);
}

TEST(AbsoluteColorLoss, IsTheMeanOfAbsoluteErrorsWithTheObjectsPixelsWeighted) {
  auto planes = torch::zeros({1, 5, 64, 64});
  planes.slice(1, 4, 5).slice(2, 0, 32).fill_(1);  // the upper half is the object
  auto drawn = torch::full({1, 3, 64, 64}, 0.1);
  drawn.slice(2, 0, 32).fill_(0.5);
  const auto rest = torch::zeros({1, 1, 64, 64});
  EXPECT_NEAR(absoluteColorLoss({drawn, rest, rest}, planes, 3).item<double>(), (3 * 0.5 + 0.1) / 4,
              1e-5);
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
  auto right = torch::full({2, 7, 3}, -20.0);
  right.select(2, 0).fill_(0);
  const auto merged = right.clone();
  auto changed = torch::zeros({2, 7}, torch::kBool);
  for (int image = 4; image < 7; ++image) {  // of group 0 show another value
    changed[0][image] = true;
    right[0][image][0] = -20;
    right[0][image][1] = 0;
  }
  EXPECT_NEAR(pairLikelihoodLoss(right, changed).item<double>(), 0, 1e-3);
  EXPECT_GT(pairLikelihoodLoss(merged, changed).item<double>(), 5);
}

TEST(PairLikelihoodLoss, AveragesPairsThatAgreeAndPairsThatDifferApart) {
  const auto even = torch::full({1, 7, 2}, -std::log(2.0));
  auto changed = torch::zeros({1, 7}, torch::kBool);
  EXPECT_NEAR(pairLikelihoodLoss(even, changed).item<double>(), std::log(2.0), 1e-4);
  changed[0][6] = true;
  EXPECT_NEAR(pairLikelihoodLoss(even, changed).item<double>(), 2 * std::log(2.0), 1e-4);
}

// With a gradient that fades, images that are sure of the wrong prototype would stay.
TEST(PairLikelihoodLoss, PullsHardAtImagesThatAreSureAndWrong) {
  const auto changed = torch::tensor({{false, false, true}});
  auto logits = torch::tensor({{{12.0, 0.0}, {-12.0, 0.0}, {12.0, 0.0}}}, torch::requires_grad());
  pairLikelihoodLoss(torch::log_softmax(logits, -1), changed).backward();
  EXPECT_LT(logits.grad()[0][1][0].item<double>(), -0.2);  // towards the image it agrees with
  EXPECT_GT(logits.grad()[0][2][0].item<double>(), 0.2);   // away from the one it differs from
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

/// Terms of known values that have gradients.
ConceptTerms sampleTerms() {
  const auto term = [](double value) { return torch::tensor(value, torch::requires_grad()); };
  ConceptTerms terms;
  terms.disentangling = term(1);
  terms.reconstruction = term(2);
  terms.direct = term(3);
  terms.location = term(5);
  terms.pair = term(7);
  terms.use = term(11);
  terms.confidence = term(13);
  return terms;
}

TEST(ConceptLoss, Eq3IsTheWeightedSumOfDisentanglingReconstructionAndDirectBranch) {
  ConceptTrainingOptions options;
  options.disentangling_weight = 2;
  options.reconstruction_weight = 10;
  options.pair_weight = 0.5;
  options.use_weight = 4;
  options.confidence_weight = 3;
  const ConceptTerms terms = sampleTerms();
  const auto loss = conceptLoss(terms, options, /*sharpening=*/false);
  EXPECT_NEAR(loss.item<double>(), 2 * 1 + 10 * (2 + 3) + 5 + 0.5 * 7 + 4 * 11, 1e-4);
  loss.backward();
  EXPECT_EQ(terms.disentangling.grad().item<double>(), 2);
  EXPECT_EQ(terms.reconstruction.grad().item<double>(), 10);
  EXPECT_EQ(terms.direct.grad().item<double>(), 10);
  EXPECT_EQ(terms.location.grad().item<double>(), 1);
  EXPECT_EQ(terms.pair.grad().item<double>(), 0.5);
  EXPECT_EQ(terms.use.grad().item<double>(), 4);
  EXPECT_FALSE(terms.confidence.grad().defined());

  const ConceptTerms sharpened = sampleTerms();
  const auto more = conceptLoss(sharpened, options, /*sharpening=*/true);
  EXPECT_NEAR((more - loss).item<double>(), 3 * 13, 1e-4);
  more.backward();
  EXPECT_EQ(sharpened.confidence.grad().item<double>(), 3);
}

TEST(ConceptLoss, Eq3OfThePapersProfileIsThePapersTermsAloneAndThePlace) {
  EXPECT_NEAR(conceptLoss(sampleTerms(), paperConceptTraining(), false).item<double>(),
              1 + 2 + 3 + 5, 1e-5);
}

}  // namespace
}  // namespace conceptplan
