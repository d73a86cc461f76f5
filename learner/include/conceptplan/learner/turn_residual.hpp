#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "conceptplan/domain/camera.hpp"
#include "conceptplan/domain/image.hpp"

namespace conceptplan {

/// One object in a picture.
struct ObjectView {
  const RgbdImage& image;
  std::uint8_t instance;    ///< id in the mask
  Eigen::Vector2d p_WAxis;  ///< where the upright axis about which it turns stands: its cell
};

/// By how much two pictures of one object contradict that it was turned by so many quarter turns,
/// counter-clockwise seen from above, between them; 0 to about 1. It needs no learned object: what
/// is seen in either picture is turned, put at the other place, and looked for in the other
/// picture. A point counts 1 where something farther or the floor is seen through it; by how much
/// paint differs, where it meets the surface; and a third where it may be hidden. The object may
/// have been dyed, so that only grey differs from coloured, and light from dark grey. The floor is
/// where it is seen around the object, and the axis may lie 4 cm off, so that a camera which is not
/// quite where it is said to be does no harm.
/// 1 where a picture has no pixel of the object whose depth is known.
/// @throws std::invalid_argument if a picture is not of the camera's size.
double turnResidual(const ObjectView& before, const ObjectView& after, int quarter_turns,
                    const Camera& camera);

}  // namespace conceptplan
