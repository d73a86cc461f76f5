#pragma once

#include <cstdint>

#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// The seed of all that varies between pictures of the same world: textures of workbench, wall and
/// floor, light, colour samples and, in the shifted domain, camera pose and lens noise. Frames of
/// one task share it.
struct Appearance {
  std::uint64_t seed = 0;
  RenderDomain domain = RenderDomain::kStandard;
};

}  // namespace conceptplan
