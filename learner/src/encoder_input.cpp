#include "conceptplan/learner/encoder_input.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

constexpr float kDepthLevel_m = 0.001F;
constexpr float kDepthOrigin_m = 2.0F;
constexpr float kDepthUnit_m = 0.5F;
constexpr float kDepthMiddle = 128.0F;

float medianDepth(const ObjectCrop& crop) {
  std::vector<float> depths;
  for (int i = 0; i < EncoderInput::kPixels; ++i)
    if (crop.mask[i] != 0 && crop.depth_m[i] > 0) depths.push_back(crop.depth_m[i]);
  if (depths.empty()) return kDepthOrigin_m;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

}  // namespace

Eigen::Vector2d pixelOf(const std::array<float, 3>& location) {
  return {(location[0] + 1.0) * (kFrameWidth / 2.0), (location[1] + 1.0) * (kFrameHeight / 2.0)};
}

float depthOf(const std::array<float, 3>& location, float level) {
  return kDepthOrigin_m + kDepthUnit_m * location[2] + kDepthLevel_m * (level - kDepthMiddle);
}

EncoderInput encoderInput(const ObjectCrop& crop) {
  constexpr std::size_t kPixels = EncoderInput::kPixels;
  if (crop.rgb.size() != 3 * kPixels || crop.depth_m.size() != kPixels ||
      crop.mask.size() != kPixels)
    throw std::invalid_argument("encoderInput: expected planes of 64 x 64, found " +
                                std::to_string(crop.mask.size()) + " mask pixels");
  if (std::none_of(crop.mask.begin(), crop.mask.end(), [](auto m) { return m != 0; }))
    throw std::invalid_argument("encoderInput: no pixel of the crop is on the object");

  const float median = medianDepth(crop);
  EncoderInput input;
  input.planes.assign(EncoderInput::kChannels * kPixels, 0);
  for (std::size_t i = 0; i < kPixels; ++i) {
    if (crop.mask[i] == 0) continue;
    for (std::size_t channel = 0; channel < 3; ++channel)
      input.planes[channel * kPixels + i] = crop.rgb[3 * i + channel];
    const float relative = crop.depth_m[i] > 0 ? (crop.depth_m[i] - median) / kDepthLevel_m : 0.0F;
    input.planes[3 * kPixels + i] =
        static_cast<std::uint8_t>(std::lround(std::clamp(kDepthMiddle + relative, 1.0F, 255.0F)));
    input.planes[4 * kPixels + i] = 255;
  }
  constexpr float kHalf = ObjectCrop::kEdge / 2.0F;
  input.location = {(static_cast<float>(crop.left) + kHalf) / (kFrameWidth / 2.0F) - 1.0F,
                    (static_cast<float>(crop.top) + kHalf) / (kFrameHeight / 2.0F) - 1.0F,
                    (median - kDepthOrigin_m) / kDepthUnit_m};
  return input;
}

}  // namespace conceptplan
