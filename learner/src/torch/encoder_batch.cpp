#include "conceptplan/learner/torch/encoder_batch.hpp"

#include <algorithm>
#include <cmath>

namespace conceptplan {
namespace {

constexpr std::int64_t kEdge = EncoderInput::kEdge;

/// Copies between a crop and its place in a frame of 384 x 256, as far as it lies within.
/// frame [c, 256, 384], crop [c, 64, 64], location [3].
void copyCrop(torch::Tensor frame, torch::Tensor crop, const torch::Tensor& location,
              bool into_frame) {
  const Eigen::Vector2d centre =
      pixelOf({location[0].item<float>(), location[1].item<float>(), location[2].item<float>()});
  constexpr double kFarthest_px = 1e6;
  // Nothing of a crop so far away, or nowhere, lies within.
  if (!(centre.cwiseAbs().maxCoeff() <= kFarthest_px) || !centre.allFinite()) return;
  const auto left = std::lround(centre.x()) - kEdge / 2;
  const auto top = std::lround(centre.y()) - kEdge / 2;
  const std::int64_t x0 = std::clamp<std::int64_t>(left, 0, kFrameWidth);
  const std::int64_t y0 = std::clamp<std::int64_t>(top, 0, kFrameHeight);
  const std::int64_t x1 = std::clamp<std::int64_t>(left + kEdge, 0, kFrameWidth);
  const std::int64_t y1 = std::clamp<std::int64_t>(top + kEdge, 0, kFrameHeight);
  if (x1 <= x0 || y1 <= y0) return;
  const auto in_frame = frame.slice(1, y0, y1).slice(2, x0, x1);
  const auto in_crop = crop.slice(1, y0 - top, y1 - top).slice(2, x0 - left, x1 - left);
  if (into_frame)
    in_frame.copy_(in_crop);
  else
    in_crop.copy_(in_frame);
}

}  // namespace

EncoderBatch encoderBatch(std::span<const EncoderInput> inputs) {
  const auto count = static_cast<std::int64_t>(inputs.size());
  EncoderBatch batch{torch::empty({count, EncoderInput::kChannels, kEdge, kEdge}, torch::kUInt8),
                     torch::empty({count, 3})};
  auto* bytes = batch.bytes.data_ptr<std::uint8_t>();
  auto* location = batch.location.data_ptr<float>();
  for (const EncoderInput& input : inputs) {
    bytes = std::copy(input.planes.begin(), input.planes.end(), bytes);
    location = std::copy(input.location.begin(), input.location.end(), location);
  }
  return batch;
}

torch::Tensor encoderPlanes(const torch::Tensor& bytes, const torch::Tensor& location,
                            EncoderKind encoder) {
  const auto planes = bytes.to(torch::kFloat) / 255.0;
  if (encoder == EncoderKind::kObjectCentred) return planes;
  auto frame = torch::zeros({bytes.size(0), EncoderInput::kChannels, kFrameHeight, kFrameWidth});
  for (std::int64_t i = 0; i < bytes.size(0); ++i) copyCrop(frame[i], planes[i], location[i], true);
  return torch::adaptive_avg_pool2d(frame, {kFullFrameEdge, kFullFrameEdge});
}

torch::Tensor cropsOf(const torch::Tensor& frames, const torch::Tensor& location) {
  const auto wide = torch::upsample_bilinear2d(frames, {kFrameHeight, kFrameWidth}, false);
  auto crops = torch::zeros({frames.size(0), frames.size(1), kEdge, kEdge});
  for (std::int64_t i = 0; i < frames.size(0); ++i) copyCrop(wide[i], crops[i], location[i], false);
  return crops;
}

}  // namespace conceptplan
