#include "rendering/color.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace conceptplan::rendering {

using Eigen::Vector3f;

Vector3f linear(const Vector3f& srgb) {
  return srgb.unaryExpr(
      [](float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); });
}

Vector3f fromHsv(float hue_deg, float saturation, float value) {
  const auto component = [&](float offset) {
    const float k = std::fmod(offset + hue_deg / 60 + 12, 6.0F);
    return value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0F, 1.0F));
  };
  return {component(5), component(3), component(1)};
}

std::uint8_t encode(float value) {
  constexpr int kSteps = 4096;
  constexpr float kBrightest = 2;
  static const auto table = [] {
    std::array<std::uint8_t, kSteps + 1> codes{};
    for (int i = 0; i <= kSteps; ++i) {
      const float x = kBrightest * static_cast<float>(i) / kSteps;
      constexpr float kKnee = 0.75F;
      const float toned =
          x < kKnee ? x : kKnee + (1 - kKnee) * (1 - std::exp(-(x - kKnee) / (1 - kKnee)));
      const float srgb =
          toned <= 0.0031308F ? 12.92F * toned : 1.055F * std::pow(toned, 1 / 2.4F) - 0.055F;
      codes[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(255 * srgb + 0.5F);
    }
    return codes;
  }();
  const float place = std::clamp(value / kBrightest, 0.0F, 1.0F) * kSteps;
  return table[static_cast<std::size_t>(place + 0.5F)];
}

Vector3f bodyAlbedo(int color, int sample) {
  // Multiples of three irrationals modulo 1 spread any number of samples evenly.
  const auto spread = [sample](float step, float low, float high) {
    const float x = step * (static_cast<float>(sample) + 0.5F);
    return low + (high - low) * (x - std::floor(x));
  };
  const float hue = 60 * static_cast<float>(color) + spread(0.8191725F, -8, 8);
  const float saturation = spread(0.6710436F, 0.74F, 0.94F);
  const float value = spread(0.5497005F, 0.74F, 0.94F);
  return linear(fromHsv(hue, saturation, value));
}

}  // namespace conceptplan::rendering
