#pragma once

#include <torch/torch.h>

#include <filesystem>
#include <string>

#include "conceptplan/learner/tensor_file.hpp"

namespace conceptplan {

/// The parameters of a module as numbers, their names preceded by `prefix`.
NamedTensors tensorsOf(const torch::nn::Module& module, const std::string& prefix);

/// Sets the parameters of a module.
/// @param path stands in the faults. @throws InputError with every tensor that is missing or has
/// another shape; then nothing was set.
void setTensors(torch::nn::Module& module, const NamedTensors& tensors, const std::string& prefix,
                const std::filesystem::path& path);

}  // namespace conceptplan
