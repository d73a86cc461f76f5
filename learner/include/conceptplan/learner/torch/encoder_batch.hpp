#pragma once

#include <torch/torch.h>

#include <span>

#include "conceptplan/learner/encoder_input.hpp"
#include "conceptplan/learner/encoder_kind.hpp"

namespace conceptplan {

inline constexpr std::int64_t kFullFrameEdge = 256;

/// Encoder inputs side by side.
struct EncoderBatch {
  torch::Tensor bytes;     ///< [B, 5, 64, 64], unsigned bytes
  torch::Tensor location;  ///< [B, 3]
};

EncoderBatch encoderBatch(std::span<const EncoderInput> inputs);

/// The bytes of inputs as the encoder takes them: planes [B, 5, 64, 64] in 0..1, or, for the full
/// frame, the foreground alone in its place, squeezed to [B, 5, 256, 256].
torch::Tensor encoderPlanes(const torch::Tensor& bytes, const torch::Tensor& location,
                            EncoderKind encoder);

/// The crops at those locations of frames squeezed so. frames [B, c, 256, 256], location [B, 3]
/// -> [B, c, 64, 64], 0 outside the frame.
torch::Tensor cropsOf(const torch::Tensor& frames, const torch::Tensor& location);

}  // namespace conceptplan
