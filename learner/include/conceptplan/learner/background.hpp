#pragma once

#include <cstdint>
#include <vector>

#include "conceptplan/domain/image.hpp"

namespace conceptplan {

/// A frame without one of its objects.
struct Background {
  RgbdImage image;                 ///< floor and depth continued into the hole; not in the mask
  std::vector<std::uint8_t> hole;  ///< [height, width], 1 where the object hid the floor
};

/// 1 where an instance is, grown by ten pixels, except on other instances: [height, width].
std::vector<std::uint8_t> holeOf(const RgbdImage& image, std::uint8_t instance);

/// The frame with a piece of the same floor in place of an instance: the piece, moved along the
/// plane of the floor, whose surroundings look most like the hole's. It is added to what differs
/// between them, spread over the hole, so that light and shade go on; where the frame has no such
/// piece, the colours around the hole are spread. Source: membrane cloning, P. Perez et al.,
/// Poisson Image Editing, 2003, doi:10.1145/882262.882269, with weights of D. Shepard, 1968,
/// doi:10.1145/800186.810616. Depth goes on as the plane.
/// @throws std::invalid_argument if the frame has no such instance, or parts of other sizes.
Background backgroundWithout(const RgbdImage& image, std::uint8_t instance);

}  // namespace conceptplan
