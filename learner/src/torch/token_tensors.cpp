#include "conceptplan/learner/torch/token_tensors.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace conceptplan {

torch::Tensor toTensor(std::span<const Tokens> tokens) {
  auto tensor = torch::empty({static_cast<std::int64_t>(tokens.size()), Tokens::RowsAtCompileTime,
                              Tokens::ColsAtCompileTime});
  auto* to = tensor.data_ptr<float>();
  for (const Tokens& one : tokens) to = std::copy(one.data(), one.data() + one.size(), to);
  return tensor;
}

std::vector<Tokens> toTokens(const torch::Tensor& tensor) {
  if (tensor.dim() != 3 || tensor.size(1) != Tokens::RowsAtCompileTime ||
      tensor.size(2) != Tokens::ColsAtCompileTime) {
    std::ostringstream text;
    text << "toTokens: expected [N, 6, 64], found " << tensor.sizes();
    throw std::invalid_argument(text.str());
  }
  const auto flat = tensor.detach().contiguous();
  const float* from = flat.data_ptr<float>();
  std::vector<Tokens> tokens(static_cast<std::size_t>(tensor.size(0)));
  for (Tokens& one : tokens) {
    std::copy(from, from + one.size(), one.data());
    from += one.size();
  }
  return tokens;
}

}  // namespace conceptplan
