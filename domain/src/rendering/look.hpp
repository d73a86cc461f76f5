#pragma once

#include <cstdint>

#include "conceptplan/domain/camera.hpp"
#include "conceptplan/domain/rendering/appearance.hpp"
#include "rendering/light.hpp"
#include "rendering/room.hpp"

namespace conceptplan::rendering {

/// Gaussian noise that stays the same for a pixel of an appearance.
class LensNoise {
 public:
  LensNoise(std::uint64_t seed, float sigma) : seed_(seed), sigma_(sigma) {}
  /// In steps of the 8-bit range.
  float at(int x, int y, int channel) const;
  bool silent() const { return sigma_ == 0; }

 private:
  std::uint64_t seed_;
  float sigma_;
};

/// All that an appearance decides, drawn from its seed.
struct Look {
  explicit Look(const Appearance& appearance);

  Appearance appearance;
  Camera camera;
  Light light;
  RoomStyle style;
  LensNoise noise;

 private:
  Look(const Appearance& from, RandomStream&& camera_draws, RandomStream&& light_draws,
       RandomStream&& style_draws);
};

}  // namespace conceptplan::rendering
