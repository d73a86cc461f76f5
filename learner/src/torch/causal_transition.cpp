#include "conceptplan/learner/torch/causal_transition.hpp"

#include "conceptplan/domain/action.hpp"

namespace conceptplan {
namespace {

namespace nn = torch::nn;
constexpr std::int64_t kConceptCount = static_cast<std::int64_t>(kNumConcepts);
constexpr std::int64_t kActionWidth = 64;
constexpr std::int64_t kConceptWidth = 16;
constexpr std::int64_t kHidden = 256;

}  // namespace

CausalTransitionImpl::CausalTransitionImpl() {
  action_embedding_ = register_module(
      "action_embedding", nn::Embedding(static_cast<std::int64_t>(kNumActions), kActionWidth));
  concept_embedding_ =
      register_module("concept_embedding", nn::Embedding(kConceptCount, kConceptWidth));
  perceptron_ = register_module(
      "perceptron",
      nn::Sequential(nn::Linear(2 * kTokenWidth + kActionWidth + kConceptWidth, kHidden),
                     nn::GELU(), nn::Linear(kHidden, kHidden), nn::GELU(),
                     nn::Linear(kHidden, kHidden), nn::GELU(), nn::Linear(kHidden, kTokenWidth)));
}

torch::Tensor CausalTransitionImpl::forward(const torch::Tensor& tokens,
                                            const torch::Tensor& context,
                                            const torch::Tensor& actions) {
  const std::int64_t batch = tokens.size(0);
  const auto action =
      action_embedding_(actions).unsqueeze(1).expand({batch, kConceptCount, kActionWidth});
  const auto of_concept = concept_embedding_(torch::arange(kConceptCount))
                              .unsqueeze(0)
                              .expand({batch, kConceptCount, kConceptWidth});
  const auto change = perceptron_->forward(torch::cat({tokens, context, action, of_concept}, -1));
  return torch::layer_norm(tokens + change, {kTokenWidth});
}

}  // namespace conceptplan
