#include "conceptplan/learner/torch/object_drawer.hpp"

#include <gtest/gtest.h>

#include "conceptplan/learner/torch/concept_network.hpp"

namespace conceptplan {
namespace {

TEST(BoundingBoxes, AreMiddlesAndHalfExtentsWithTheCropFromMinus1To1) {
  auto mask = torch::zeros({2, 1, 64, 64});
  mask[0][0].slice(0, 40, 64).slice(1, 8, 24).fill_(1);  // rows 40..63, columns 8..23
  mask[1].fill_(1);
  const auto expected = torch::tensor({{-0.5, 0.625, 0.25, 0.375}, {0.0, 0.0, 1.0, 1.0}});
  EXPECT_TRUE(torch::allclose(boundingBoxes(mask), expected)) << boundingBoxes(mask);
}

/// A drawer whose pictures are an object all over but for the margin around its box.
ObjectDrawer drawerOfFullBoxes() {
  ObjectDrawer drawer;
  const torch::NoGradGuard no_gradient;
  for (auto& parameter : drawer->parameters()) parameter.zero_();
  auto picture = torch::zeros({5, 48, 48});
  picture[3].fill_(-20);
  picture[3].slice(0, 3, 45).slice(1, 3, 45).fill_(20);
  drawer->named_parameters()["mixture.4.bias"].copy_(picture.flatten());
  return drawer;
}

TEST(ObjectDrawer, FillsTheBoxThatItIsGiven) {
  const torch::NoGradGuard no_gradient;
  const auto boxes = torch::tensor({{-0.5, 0.25, 0.25, 0.5}, {0.25, 0.0, 0.5, 0.125}});
  const auto drawn = drawerOfFullBoxes()->forward(torch::zeros({2, 6, 64}), boxes);
  const auto found = boundingBoxes(torch::sigmoid(drawn.mask_logits));
  EXPECT_LT((found - boxes).abs().max().item<double>(), 1.01 / 32) << found;
}

TEST(ObjectDrawer, HasAGradientForItsBoxes) {
  auto boxes = torch::tensor({{0.1, 0.2, 0.3, 0.4}}, torch::requires_grad());
  const auto drawn = drawerOfFullBoxes()->forward(torch::zeros({1, 6, 64}), boxes);
  torch::sigmoid(drawn.mask_logits).sum().backward();  // the object's area
  EXPECT_GT(boxes.grad()[0][2].item<double>(), 0);
  EXPECT_GT(boxes.grad()[0][3].item<double>(), 0);
}

TEST(ConceptNetwork, DrawsWithTheDrawerInTheBoxThatItFinds) {
  torch::manual_seed(4);
  ConceptNetwork network;
  const torch::NoGradGuard no_gradient;
  const auto tokens = torch::randn({2, 6, 64});
  const auto drawn = network->draw(tokens);
  ObjectDrawer& drawer = network->drawer();
  EXPECT_TRUE(torch::equal(drawn.rgb, drawer->forward(tokens, drawer->locateInCrop(tokens)).rgb));
}

TEST(ConceptNetwork, DrawsWholeFramesWithTheDecoder) {
  torch::manual_seed(4);
  ConceptNetwork network(EncoderKind::kFullFrame);
  const torch::NoGradGuard no_gradient;
  const auto tokens = torch::randn({1, 6, 64});
  EXPECT_TRUE(network->drawer().is_empty());
  EXPECT_TRUE(
      torch::equal(network->draw(tokens).rgb, network->decode(network->detokenize(tokens)).rgb));
}

}  // namespace
}  // namespace conceptplan
