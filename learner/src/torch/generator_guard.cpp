#include "conceptplan/learner/torch/generator_guard.hpp"

#include <ATen/CPUGeneratorImpl.h>

namespace conceptplan {
namespace {

std::recursive_mutex& guardMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

}  // namespace

GeneratorGuard::GeneratorGuard() : alone_(guardMutex()) {
  at::Generator generator = at::detail::getDefaultCPUGenerator();
  const std::lock_guard<std::mutex> lock(generator.mutex());
  state_ = generator.get_state();
}

GeneratorGuard::GeneratorGuard(std::uint64_t seed) : GeneratorGuard() {
  at::Generator generator = at::detail::getDefaultCPUGenerator();
  const std::lock_guard<std::mutex> lock(generator.mutex());
  generator.set_current_seed(seed);
}

GeneratorGuard::~GeneratorGuard() {
  at::Generator generator = at::detail::getDefaultCPUGenerator();
  const std::lock_guard<std::mutex> lock(generator.mutex());
  generator.set_state(state_);
}

}  // namespace conceptplan
