#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace conceptplan::rendering {

/// Linear RGB of an sRGB colour with components in [0, 1].
Eigen::Vector3f linear(const Eigen::Vector3f& srgb);
/// Hue in degrees, saturation and value in [0, 1]; sRGB.
Eigen::Vector3f fromHsv(float hue_deg, float saturation, float value);
/// The 8-bit sRGB value of a linear one; bright values are compressed, not cut.
std::uint8_t encode(float linear);

/// The linear albedo of an object's body.
/// @param color in [0, 6)
/// @param sample in [0, kColorSamples)
Eigen::Vector3f bodyAlbedo(int color, int sample);

}  // namespace conceptplan::rendering
