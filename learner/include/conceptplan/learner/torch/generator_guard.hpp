#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <mutex>

namespace conceptplan {

/// Leaves Torch's default CPU generator in the state in which it was found: fresh networks draw
/// their weights from it, and it is the program's, not ours. One guard exists at a time; another
/// thread waits for it. What another thread draws from the generator meanwhile is of the guarded
/// stream, and is not reproducible.
class GeneratorGuard {
 public:
  GeneratorGuard();
  /// Seeds the generator, as `torch::manual_seed` does, but those of no other device.
  explicit GeneratorGuard(std::uint64_t seed);
  ~GeneratorGuard();
  GeneratorGuard(const GeneratorGuard&) = delete;
  GeneratorGuard& operator=(const GeneratorGuard&) = delete;

 private:
  std::unique_lock<std::recursive_mutex> alone_;
  torch::Tensor state_;
};

}  // namespace conceptplan
