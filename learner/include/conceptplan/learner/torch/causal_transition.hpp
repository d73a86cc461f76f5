#pragma once

#include <torch/torch.h>

#include "conceptplan/learner/torch/concept_network.hpp"

namespace conceptplan {

/// The causal transition T on concept tokens: C1' = T(C0, V(a)), Eq. (7) of arXiv 2310.03325. One
/// perceptron of four layers serves all six tokens. Besides token and action embedding it is given
/// which concept the token is of, and a context token: the same concept's token of the object that
/// the effect was learned to depend on (the dyer's colour), or zeros. The context is ours: without
/// it no function of the target alone can know the new colour.
class CausalTransitionImpl : public torch::nn::Module {
 public:
  CausalTransitionImpl();

  /// tokens [B, 6, 64], context [B, 6, 64], actions [B] in [0, 7) -> [B, 6, 64] of length 8.
  torch::Tensor forward(const torch::Tensor& tokens, const torch::Tensor& context,
                        const torch::Tensor& actions);

 private:
  torch::nn::Embedding action_embedding_{nullptr};
  torch::nn::Embedding concept_embedding_{nullptr};
  torch::nn::Sequential perceptron_{nullptr};
};
TORCH_MODULE(CausalTransition);

}  // namespace conceptplan
