#include "conceptplan/learner/torch/concept_losses.hpp"

#include <cmath>

namespace conceptplan {
namespace {
constexpr double kLeastProbability = 1e-5;
}

torch::Tensor reconstructionLoss(const DecodedObject& drawn, const torch::Tensor& planes,
                                 double foreground_weight) {
  const auto depth = planes.slice(1, 3, 4), mask = planes.slice(1, 4, 5);
  const auto error = (drawn.rgb - planes.slice(1, 0, 3)).square().mean(1, /*keepdim=*/true);
  const auto weight = 1 + (foreground_weight - 1) * mask;
  const auto depth_error = mask * (drawn.depth - depth).square();
  return (weight * error).sum() / weight.sum() + depth_error.sum() / mask.sum().clamp_min(1) +
         0.1 * torch::binary_cross_entropy_with_logits(drawn.mask_logits, mask);
}

torch::Tensor conceptDisentanglingLoss(const torch::Tensor& first, const torch::Tensor& second,
                                       const torch::Tensor& differing) {
  const auto distances = ((first - second).square().sum(-1) + 1e-6).sqrt();  // [B, 6]
  return torch::cross_entropy_loss(distances, differing);
}

torch::Tensor pairLikelihoodLoss(const torch::Tensor& values, const torch::Tensor& odd,
                                 std::int64_t odd_image) {
  const auto same = torch::matmul(values, values.transpose(1, 2))
                        .clamp(kLeastProbability, 1 - kLeastProbability);  // [G, 7, 7]
  const std::int64_t images = values.size(1);
  auto above = torch::ones({images, images}).triu(1);
  auto involves_odd = torch::zeros({images, images});
  involves_odd.select(0, odd_image).fill_(1);
  involves_odd.select(1, odd_image).fill_(1);
  const auto differ = odd.to(torch::kFloat).view({-1, 1, 1}) * involves_odd * above;  // [G, 7, 7]
  const auto agree = above - differ;
  return -(agree * same.log()).sum() / agree.sum() -
         (differ * (1 - same).log()).sum() / differ.sum().clamp_min(1);
}

torch::Tensor prototypeUseLoss(const torch::Tensor& values) {
  const auto use = values.mean(0).clamp_min(kLeastProbability);
  return std::log(static_cast<double>(values.size(1))) + (use * use.log()).sum();
}

torch::Tensor prototypeEntropy(const torch::Tensor& values) {
  return -(values * values.clamp_min(kLeastProbability).log()).sum(1).mean();
}

}  // namespace conceptplan
