#include "conceptplan/learner/torch/frame_synthesizer.hpp"

namespace conceptplan {
namespace {

namespace nn = torch::nn;

nn::Conv2d convolution(std::int64_t in, std::int64_t out, std::int64_t kernel, std::int64_t stride,
                       std::int64_t dilation = 1) {
  return nn::Conv2d(nn::Conv2dOptions(in, out, kernel)
                        .stride(stride)
                        .dilation(dilation)
                        .padding(dilation * (kernel - 1) / 2));
}

/// Colours without the hole, continued into it by averages over ever larger neighbourhoods of what
/// is known: the pull-push algorithm of S. J. Gortler et al., 1996, doi:10.1145/237170.237200. seen
/// [B, 3, E, E], black in the hole; known [B, 1, E, E] in 0..1 -> [B, 3, E, E].
torch::Tensor continued(const torch::Tensor& seen, const torch::Tensor& known) {
  if (seen.size(-1) % 2 != 0) {
    const auto mean = seen.sum({2, 3}, true) / known.sum({2, 3}, true).clamp_min(1e-6);
    return torch::where(known > 0, seen / known.clamp_min(1e-6), mean);
  }
  const auto coarse = continued(torch::avg_pool2d(seen, 2), torch::avg_pool2d(known, 2));
  return seen + (1 - known) * torch::upsample_bilinear2d(coarse, {seen.size(-2), seen.size(-1)},
                                                         /*align_corners=*/false);
}

}  // namespace

FrameSynthesizerImpl::FrameSynthesizerImpl() {
  fine_ = register_module("fine", nn::Sequential(convolution(8, 24, 5, 2), nn::ReLU(),
                                                 convolution(24, 24, 3, 1), nn::ReLU()));
  middle_ = register_module("middle", nn::Sequential(convolution(24, 48, 3, 2), nn::ReLU(),
                                                     convolution(48, 48, 3, 1), nn::ReLU()));
  coarse_ = register_module("coarse", nn::Sequential(convolution(48, 96, 3, 2), nn::ReLU()));
  deepest_ =
      register_module("deepest", nn::Sequential(convolution(96, 96, 3, 1, 2), nn::ReLU(),
                                                convolution(96, 96, 3, 1, 4), nn::ReLU(),
                                                convolution(96, 192, 3, 1), nn::PixelShuffle(2)));
  to_middle_ =
      register_module("to_middle", nn::Sequential(convolution(96, 64, 3, 1), nn::ReLU(),
                                                  convolution(64, 128, 3, 1), nn::PixelShuffle(2)));
  to_fine_ =
      register_module("to_fine", nn::Sequential(convolution(56, 48, 3, 1), nn::ReLU(),
                                                convolution(48, 64, 3, 1), nn::PixelShuffle(2)));
  to_frame_ = register_module("to_frame", nn::Sequential(nn::ReLU(), convolution(24, 4, 3, 1)));
}

torch::Tensor FrameSynthesizerImpl::forward(const torch::Tensor& background,
                                            const torch::Tensor& hole, const torch::Tensor& object,
                                            const torch::Tensor& alpha) {
  const auto floor = continued(background, 1 - hole);
  const auto input = torch::cat({floor, hole, object * alpha, alpha}, 1)
                         .contiguous(torch::MemoryFormat::ChannelsLast);
  const auto at_half = fine_->forward(input);                                 // [B, 24, 48, 48]
  const auto at_quarter = middle_->forward(at_half);                          // [B, 48, 24, 24]
  const auto from_deepest = deepest_->forward(coarse_->forward(at_quarter));  // [B, 48, 24, 24]
  const auto up = to_middle_->forward(torch::cat({from_deepest, at_quarter}, 1));
  const auto finest = to_fine_->forward(torch::cat({up, at_half}, 1));    // [B, 16, 96, 96]
  const auto drawn = to_frame_->forward(torch::cat({finest, input}, 1));  // [B, 4, 96, 96]
  // The floor is kept, but for a shade factor and a change that is small outside the hole.
  const auto change = torch::tanh(drawn.slice(1, 0, 3));
  const auto filled =
      floor * (2 * torch::sigmoid(drawn.slice(1, 3, 4))) + (0.25 + 0.25 * hole) * change;
  return (alpha * (object + 0.25 * change) + (1 - alpha) * filled).clamp(0, 1);
}

}  // namespace conceptplan
