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
/// is seen in either picture is turned, put at the other place, and looked for in the other one.
/// A point counts 1 where the floor or something farther is seen in its place; a third where it may
/// be hidden, lies outside the frame, or nothing is known of the depth; and where it meets the
/// surface by how much paint differs. The object may have been dyed, so that only grey differs from
/// coloured, and light from dark grey.
/// The floor's height is that of what is seen of it around the object, 0 if nothing is. The axis
/// may lie 3 cm off along x and y, so that a camera which is not quite where it is said to be does
/// no harm. 1 where a picture has no pixel of the object whose depth is known.
/// @throws std::invalid_argument if a picture is not of the camera's size.
double turnResidual(const ObjectView& before, const ObjectView& after, int quarter_turns,
                    const Camera& camera);

}  // namespace conceptplan
