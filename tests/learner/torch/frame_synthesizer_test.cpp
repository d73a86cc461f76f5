#include "conceptplan/learner/torch/frame_synthesizer.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

constexpr std::int64_t kEdge = FrameSynthesizerImpl::kWindow;

/// A network whose weights are all 0 changes nothing but what it is built to.
FrameSynthesizer untrained() {
  FrameSynthesizer synthesizer;
  const torch::NoGradGuard no_gradient;
  for (auto& parameter : synthesizer->parameters()) parameter.zero_();
  return synthesizer;
}

struct Window {
  torch::Tensor floor = torch::zeros({1, 3, kEdge, kEdge});
  torch::Tensor hole = torch::zeros({1, 1, kEdge, kEdge});
  torch::Tensor object = torch::zeros({1, 3, kEdge, kEdge});
  torch::Tensor alpha = torch::zeros({1, 1, kEdge, kEdge});

  torch::Tensor drawn() const {
    const torch::NoGradGuard no_gradient;
    return untrained()->forward(floor, hole, object, alpha);
  }
};

TEST(FrameSynthesizer, KeepsTheFloor) {
  Window window;
  window.floor = torch::linspace(0, 1, kEdge).expand({1, 3, kEdge, kEdge}).clone();
  window.hole.slice(2, 30, 62).slice(3, 25, 70).fill_(1);
  EXPECT_LT((window.drawn() - window.floor).abs().max().item<double>(), 1e-6);
}

TEST(FrameSynthesizer, ChangesTheFloorSmoothlyAwayFromTheObject) {
  torch::manual_seed(5);
  FrameSynthesizer synthesizer;
  for (auto& parameter : synthesizer->parameters()) parameter.detach().mul_(3);
  Window window;
  window.floor.fill_(0.5);
  window.hole.slice(2, 20, 60).slice(3, 20, 60).fill_(1);
  window.object.fill_(0.2);
  window.alpha.slice(2, 70, 90).slice(3, 70, 90).fill_(1);
  const torch::NoGradGuard no_gradient;
  const auto drawn = synthesizer->forward(window.floor, window.hole, window.object, window.alpha);
  const auto change = (drawn - window.floor).slice(2, 0, 60);
  const auto steps = (change.slice(3, 1) - change.slice(3, 0, -1)).abs();
  const double range = (change.max() - change.min()).item<double>();
  EXPECT_GT(range, 0.02);
  // Means over 8 pixels, 4 apart, with straight lines between them.
  EXPECT_LT(steps.max().item<double>(), 0.25 * range);
}

TEST(FrameSynthesizer, PutsTheObjectOnTheFloor) {
  Window window;
  window.floor.fill_(0.6);
  window.object.fill_(0.2);
  window.alpha.slice(2, 0, 40).fill_(1);
  const auto drawn = window.drawn();
  EXPECT_NEAR(drawn[0][0][10][10].item<double>(), 0.2, 1e-6);
  EXPECT_NEAR(drawn[0][0][80][10].item<double>(), 0.6, 1e-6);
}

}  // namespace
}  // namespace conceptplan
