#include "conceptplan/learner/torch/object_drawer.hpp"

#include <utility>

#include "conceptplan/learner/torch/concept_network.hpp"
#include "network_blocks.hpp"

namespace conceptplan {
namespace {

using namespace network;
namespace functional = torch::nn::functional;

constexpr std::int64_t kPictureEdge = 48;
constexpr std::int64_t kPictures = 160;
constexpr std::int64_t kCropEdge = 64;
/// A picture reaches beyond the object's box by this factor, so that its border is background.
constexpr double kBoxMargin = 1.15;
constexpr double kLeastHalfExtent = 0.02;

/// Middles of the crop's pixels, [64].
torch::Tensor pixelCentres() { return (torch::arange(kCropEdge) + 0.5) * (2.0 / kCropEdge) - 1; }

/// Pictures [B, C, 48, 48] that fill boxes [B, 4], in crops [B, C, 64, 64].
torch::Tensor inBoxes(const torch::Tensor& pictures, const torch::Tensor& boxes) {
  const std::int64_t batch = pictures.size(0);
  const auto alongAxis = [&](std::int64_t axis) {
    const auto middle = boxes.slice(1, axis, axis + 1);
    const auto half = boxes.slice(1, axis + 2, axis + 3).clamp_min(kLeastHalfExtent);
    return (pixelCentres() - middle) / (kBoxMargin * half);  // [B, 64]
  };
  const auto x = alongAxis(0).unsqueeze(1).expand({batch, kCropEdge, kCropEdge});
  const auto y = alongAxis(1).unsqueeze(2).expand({batch, kCropEdge, kCropEdge});
  return functional::grid_sample(pictures, torch::stack({x, y}, 3),
                                 functional::GridSampleFuncOptions()
                                     .mode(torch::kBilinear)
                                     .padding_mode(torch::kBorder)
                                     .align_corners(false));
}

}  // namespace

torch::Tensor boundingBoxes(const torch::Tensor& mask) {
  const auto inside = mask.squeeze(1) > 0.5;  // [B, 64, 64]
  const auto numbers = torch::arange(kCropEdge);
  const auto ends = [&](const torch::Tensor& occupied) {
    const auto first = torch::where(occupied, numbers, torch::full({}, kCropEdge)).amin(1);
    const auto last = torch::where(occupied, numbers, torch::full({}, -1)).amax(1) + 1;
    return std::pair((first + last).to(torch::kFloat) / kCropEdge - 1,
                     (last - first).to(torch::kFloat) / kCropEdge);
  };
  const auto [x, width] = ends(inside.any(1));
  const auto [y, height] = ends(inside.any(2));
  return torch::stack({x, y, width, height}, 1);
}

ObjectDrawerImpl::ObjectDrawerImpl() {
  constexpr std::int64_t kTokenNumbers = static_cast<std::int64_t>(kNumConcepts) * kTokenWidth;
  mixture_ = register_module(
      "mixture",
      nn::Sequential(nn::Linear(kTokenNumbers, 512), nn::GELU(), nn::Linear(512, kPictures),
                     nn::GELU(),
                     nn::Linear(kPictures, kDrawnChannels * kPictureEdge * kPictureEdge)));
  refinement_ = register_module(
      "refinement",
      nn::Sequential(convolution(kDrawnChannels, 32, 3, 1), nn::ReLU(), convolution(32, 32, 3, 1),
                     nn::ReLU(), convolution(32, kDrawnChannels, 3, 1)));
  box_ = register_module(
      "box", nn::Sequential(nn::Linear(kTokenNumbers, 128), nn::GELU(), nn::Linear(128, 4)));
}

DecodedObject ObjectDrawerImpl::forward(const torch::Tensor& tokens, const torch::Tensor& boxes) {
  const auto mixed = mixture_->forward(tokens.flatten(1))
                         .view({tokens.size(0), kDrawnChannels, kPictureEdge, kPictureEdge});
  const auto refined =
      mixed + refinement_->forward(mixed.contiguous(torch::MemoryFormat::ChannelsLast));
  return decodedObject(inBoxes(refined, boxes));
}

torch::Tensor ObjectDrawerImpl::locateInCrop(const torch::Tensor& tokens) {
  return box_->forward(tokens.flatten(1));
}

}  // namespace conceptplan
