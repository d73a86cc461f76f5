#include "conceptplan/learner/torch/vict_losses.hpp"

namespace conceptplan {

torch::Tensor tokenLoss(const torch::Tensor& predicted, const torch::Tensor& truth) {
  return torch::mse_loss(predicted, truth);
}

torch::Tensor synthesisLoss(const torch::Tensor& frames, const torch::Tensor& truth) {
  return 10 * torch::mse_loss(frames, truth) + torch::l1_loss(frames, truth);
}

VictLosses synthesisErrors(const torch::Tensor& frames, const torch::Tensor& truth,
                           const torch::Tensor& reconstruction) {
  const torch::NoGradGuard no_gradient;
  const auto errors = (frames - truth).square().mean({1, 2, 3}, /*keepdim=*/true);
  const auto meanOf = [&](const torch::Tensor& windows) {
    return ((errors * windows).sum() / windows.sum().clamp_min(1)).item<double>();
  };
  return {0, meanOf(1 - reconstruction), meanOf(reconstruction)};
}

}  // namespace conceptplan
