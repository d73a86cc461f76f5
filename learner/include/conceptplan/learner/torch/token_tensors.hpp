#pragma once

#include <torch/torch.h>

#include <span>
#include <vector>

#include "conceptplan/learner/tokens.hpp"

namespace conceptplan {

/// [N, 6, 64].
torch::Tensor toTensor(std::span<const Tokens> tokens);

/// tensor [N, 6, 64] -> N tokens. @throws std::invalid_argument for another shape.
std::vector<Tokens> toTokens(const torch::Tensor& tensor);

}  // namespace conceptplan
