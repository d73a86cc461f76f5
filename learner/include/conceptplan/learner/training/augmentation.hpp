#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <span>

#include "conceptplan/learner/encoder_input.hpp"

namespace conceptplan {

/// How training images are varied beyond what was rendered.
struct AugmentationOptions {
  double occlusion = 0.35;     ///< share of images with a part hidden by another object
  double mask_noise = 0.2;     ///< share of images whose outline loses pixels
  double shadow = 0.25;        ///< share of images with a shadow edge across the object
  double gain = 0.12;          ///< largest relative change of brightness
  double channel_gain = 0.05;  ///< largest relative change of each colour channel
  double noise = 3.0;          ///< largest standard deviation of pixel noise, of 255
  int shift_px = 1;            ///< largest error of the crop's centre
  bool operator==(const AugmentationOptions&) const = default;
};

inline constexpr AugmentationOptions kNoAugmentation{0, 0, 0, 0, 0, 0, 0};

/// A varied copy of an image. `occluder` are the planes of another image, whose silhouette hides a
/// part; the crop is centred on what remains, as it would be in a frame, and at least 40 % remain.
EncoderInput augmented(std::span<const std::uint8_t> planes, const std::array<float, 3>& location,
                       std::span<const std::uint8_t> occluder, const AugmentationOptions& options,
                       std::mt19937_64& generator);

}  // namespace conceptplan
