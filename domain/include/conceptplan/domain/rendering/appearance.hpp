#pragma once

#include <cstddef>
#include <cstdint>

#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// The seed of all that varies between pictures of the same world: textures of workbench, wall and
/// floor, light, colour samples and, in the shifted domain, camera pose and lens noise. Frames of
/// one task share it.
///
/// Standard domain: lamp strength 0.8 to 1.2, within 0.7 m of the middle across, warmth -2 to +5 %.
/// Shifted domain: lamp strength 0.7 to 1.25, within 1.0 m, warmth -10 to +12 %, darker and tinted
/// textures; camera moved by up to 0.04 m and aimed up to 0.02 m aside along each axis, vertical
/// field of view changed by up to 2 %; a fixed pattern of Gaussian lens noise, sigma 2 to 6 of 255.
struct Appearance {
  std::uint64_t seed = 0;
  RenderDomain domain = RenderDomain::kStandard;
};

/// Each of the six colours comes in so many samples: hue within 8 degrees of its name's,
/// saturation and value in [0.74, 0.94].
inline constexpr int kColorSamples = 20;

/// The colour sample of objects[object]: (seed + 7 object) mod 20. Seeds that are equal modulo 20
/// show the same colours under different light and textures.
int colorSample(const Appearance& appearance, std::size_t object);

}  // namespace conceptplan
