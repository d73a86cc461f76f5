#include "conceptplan/learner/torch/concept_losses.hpp"

#include <cmath>

namespace conceptplan {
namespace {
constexpr double kLeastProbability = 1e-6;
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

torch::Tensor pairReconstructionLoss(const DecodedObject& drawn, const torch::Tensor& planes,
                                     double foreground_weight) {
  return 2 * reconstructionLoss(drawn, planes, foreground_weight);  // that is the mean of both
}

torch::Tensor absoluteColorLoss(const DecodedObject& drawn, const torch::Tensor& planes,
                                double foreground_weight) {
  const auto weight = 1 + (foreground_weight - 1) * planes.slice(1, 4, 5);
  const auto error = (drawn.rgb - planes.slice(1, 0, 3)).abs().mean(1, /*keepdim=*/true);
  return (weight * error).sum() / weight.sum();
}

torch::Tensor conceptDisentanglingLoss(const torch::Tensor& first, const torch::Tensor& second,
                                       const torch::Tensor& differing) {
  const auto distances = ((first - second).square().sum(-1) + 1e-6).sqrt();  // [B, 6]
  return torch::cross_entropy_loss(distances, differing);
}

torch::Tensor pairLikelihoodLoss(const torch::Tensor& log_values, const torch::Tensor& changed) {
  // log p_a(v) + log p_b(v), [G, N, N, C]. In logarithms, so that a pair that is wrong beyond doubt
  // still has a gradient.
  const auto first = log_values.unsqueeze(2), second = log_values.unsqueeze(1);
  const auto other = torch::log(-torch::expm1(second.clamp_max(-kLeastProbability)));
  const auto log_same = torch::logsumexp(first + second, -1);
  const auto log_different = torch::logsumexp(first + other, -1);
  const std::int64_t images = log_values.size(1);
  const auto above = torch::ones({images, images}).triu(1);
  const auto differ = changed.unsqueeze(2).logical_xor(changed.unsqueeze(1)) * above;  // [G, N, N]
  const auto agree = above - differ;
  return -(agree * log_same).sum() / agree.sum() -
         (differ * log_different).sum() / differ.sum().clamp_min(1);
}

torch::Tensor prototypeUseLoss(const torch::Tensor& values) {
  const auto use = values.mean(0).clamp_min(kLeastProbability);
  return std::log(static_cast<double>(values.size(1))) + (use * use.log()).sum();
}

torch::Tensor prototypeEntropy(const torch::Tensor& values) {
  return -(values * values.clamp_min(kLeastProbability).log()).sum(1).mean();
}

torch::Tensor conceptLoss(const ConceptTerms& terms, const ConceptTrainingOptions& options,
                          bool sharpening) {
  auto total = options.disentangling_weight * terms.disentangling +
               options.pair_weight * terms.pair + options.use_weight * terms.use;
  if (sharpening) total = total + options.confidence_weight * terms.confidence;
  return total + (options.reconstruction_weight * terms.reconstruction + terms.location) +
         options.reconstruction_weight * terms.direct;
}

}  // namespace conceptplan
