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

/// Its averages over squares of 8 pixels: what changes with light, without texture.
torch::Tensor smooth(const torch::Tensor& planes) {
  const auto averages = torch::avg_pool2d(planes, /*kernel_size=*/8, /*stride=*/4, /*padding=*/2,
                                          /*ceil_mode=*/false, /*count_include_pad=*/false);
  return torch::upsample_bilinear2d(averages, {planes.size(-2), planes.size(-1)},
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

torch::Tensor FrameSynthesizerImpl::forward(const torch::Tensor& floor, const torch::Tensor& hole,
                                            const torch::Tensor& object,
                                            const torch::Tensor& alpha) {
  const auto input = torch::cat({floor, hole, object * alpha, alpha}, 1)
                         .contiguous(torch::MemoryFormat::ChannelsLast);
  const auto at_half = fine_->forward(input);                                 // [B, 24, 48, 48]
  const auto at_quarter = middle_->forward(at_half);                          // [B, 48, 24, 24]
  const auto from_deepest = deepest_->forward(coarse_->forward(at_quarter));  // [B, 48, 24, 24]
  const auto up = to_middle_->forward(torch::cat({from_deepest, at_quarter}, 1));
  const auto finest = to_fine_->forward(torch::cat({up, at_half}, 1));    // [B, 16, 96, 96]
  const auto drawn = to_frame_->forward(torch::cat({finest, input}, 1));  // [B, 4, 96, 96]
  // The floor changes as light does, smoothly, so that it keeps its texture: the network can not
  // know how the texture goes on in the hole, and would average over all that it may be. Next to
  // the object, where its outline and its shadow meet, the change is as fine as the pixels.
  const auto near_object = torch::max_pool2d(alpha, /*kernel_size=*/9, /*stride=*/1, /*padding=*/4);
  const auto light = smooth(drawn);
  const auto fine = light + near_object * (drawn - light);
  const auto change = torch::tanh(fine.slice(1, 0, 3));
  const auto lit = floor * (2 * torch::sigmoid(fine.slice(1, 3, 4))) + 0.25 * change;
  return (alpha * (object + 0.25 * change) + (1 - alpha) * lit).clamp(0, 1);
}

}  // namespace conceptplan
