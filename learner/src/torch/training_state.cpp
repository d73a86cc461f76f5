#include "conceptplan/learner/torch/training_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace conceptplan {

std::mt19937_64 stepGenerator(std::uint64_t seed, std::int64_t step) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         static_cast<std::uint32_t>(step)};
  return std::mt19937_64(sequence);
}

double learningRateShare(double progress, double warm_up) {
  const double rise = warm_up > 0 ? std::min(1.0, progress / warm_up) : 1.0;
  const double cosine = 0.5 * (1 + std::cos(std::numbers::pi * std::clamp(progress, 0.0, 1.0)));
  return std::max(rise, 1e-3) * (0.02 + 0.98 * cosine);
}

void copyParameters(torch::nn::Module& to, const torch::nn::Module& from) {
  const torch::NoGradGuard no_gradient;
  const auto source = from.named_parameters();
  for (auto& parameter : to.named_parameters()) parameter.value().copy_(source[parameter.key()]);
}

void updateAverage(torch::nn::Module& average, const torch::nn::Module& source, double decay,
                   std::int64_t steps_done) {
  const torch::NoGradGuard no_gradient;
  const auto done = static_cast<double>(steps_done);
  const double followed = std::min(decay, done / (10.0 + done));
  const auto latest = source.named_parameters();
  for (auto& parameter : average.named_parameters())
    parameter.value().lerp_(latest[parameter.key()], 1 - followed);
}

}  // namespace conceptplan
