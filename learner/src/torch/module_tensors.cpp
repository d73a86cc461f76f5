#include "conceptplan/learner/torch/module_tensors.hpp"

#include <algorithm>
#include <sstream>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

std::string text(c10::IntArrayRef shape) {
  std::ostringstream out;
  out << shape;
  return out.str();
}

}  // namespace

NamedTensors tensorsOf(const torch::nn::Module& module, const std::string& prefix) {
  NamedTensors tensors;
  for (const auto& parameter : module.named_parameters()) {
    const auto flat = parameter.value().detach().contiguous().to(torch::kFloat);
    const float* from = flat.data_ptr<float>();
    tensors[prefix + parameter.key()] = {flat.sizes().vec(), {from, from + flat.numel()}};
  }
  return tensors;
}

void setTensors(torch::nn::Module& module, const NamedTensors& tensors, const std::string& prefix,
                const std::filesystem::path& path) {
  std::vector<Fault> faults;
  auto parameters = module.named_parameters();
  for (const auto& parameter : parameters) {
    const auto found = tensors.find(prefix + parameter.key());
    const std::string expected = "expected shape " + text(parameter.value().sizes());
    if (found == tensors.end())
      faults.push_back(
          {path.string(), {}, {}, prefix + parameter.key(), expected + ", found none"});
    else if (parameter.value().sizes() != found->second.shape)
      faults.push_back({path.string(),
                        {},
                        {},
                        prefix + parameter.key(),
                        expected + ", found " + text(found->second.shape)});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  const torch::NoGradGuard no_gradient;
  for (auto& parameter : parameters) {
    const NamedTensor& source = tensors.at(prefix + parameter.key());
    parameter.value().copy_(torch::tensor(source.values).view(source.shape));
  }
}

}  // namespace conceptplan
