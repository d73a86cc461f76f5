#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <random>

namespace conceptplan {

/// The generator of one training step; a resumed run draws what an uninterrupted one would.
std::mt19937_64 stepGenerator(std::uint64_t seed, std::int64_t step);

/// Half a cosine from 1 at progress 0 to 0.02 at 1, after a linear rise over `warm_up` of it.
double learningRateShare(double progress, double warm_up);

/// to = from, parameter by parameter. @pre same architecture
void copyParameters(torch::nn::Module& to, const torch::nn::Module& from);

/// average += (1 - decay) (source - average); a young average, of few steps, follows closely.
void updateAverage(torch::nn::Module& average, const torch::nn::Module& source, double decay,
                   std::int64_t steps_done);

}  // namespace conceptplan
