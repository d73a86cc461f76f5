#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "conceptplan/domain/object_crop.hpp"

namespace conceptplan {

/// A blob of one colour, with an edge that tells its rotation, as tests of the learner see objects.
inline ObjectCrop coloredBlob(std::uint64_t seed, int radius = 14) {
  std::mt19937_64 generator(seed);
  constexpr int kEdge = ObjectCrop::kEdge;
  ObjectCrop crop;
  crop.rgb.assign(3 * kEdge * kEdge, 0);
  crop.depth_m.assign(kEdge * kEdge, 0.0F);
  crop.mask.assign(kEdge * kEdge, 0);
  std::array<std::uint8_t, 3> color{};
  for (auto& channel : color) channel = static_cast<std::uint8_t>(60 + generator() % 180);
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x) {
      const int dx = x - kEdge / 2, dy = y - kEdge / 2;
      if (dx * dx + dy * dy > radius * radius) continue;
      const auto pixel = static_cast<std::size_t>(y * kEdge + x);
      crop.mask[pixel] = 1;
      crop.depth_m[pixel] = 2.0F + 0.001F * static_cast<float>(dy);
      for (std::size_t c = 0; c < 3; ++c)
        crop.rgb[3 * pixel + c] = dx > radius / 2 ? 250 : color[c];
    }
  crop.left = static_cast<int>(generator() % 300);
  crop.top = static_cast<int>(generator() % 180);
  return crop;
}

}  // namespace conceptplan
