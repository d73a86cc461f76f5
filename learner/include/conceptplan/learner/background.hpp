#pragma once

#include <cstdint>
#include <vector>

#include "conceptplan/domain/image.hpp"

namespace conceptplan {

/// A frame without one of its objects.
struct Background {
  RgbdImage image;  ///< floor and depth continued into the hole; not in the mask
  /// [height, width], 1 where the object was and up to 13 pixels from it, but for other objects.
  std::vector<std::uint8_t> hole;
};

/// The frame with a piece of the same floor in place of an instance: the piece, moved along the
/// plane of the floor, whose surroundings look most like the hole's. It is added to what differs
/// between them, spread over the hole, so that light and shade go on; where the frame has no such
/// piece, the colours around the hole are spread. Source: membrane cloning, P. Perez et al.,
/// Poisson Image Editing, 2003, doi:10.1145/882262.882269, with weights of D. Shepard, 1968,
/// doi:10.1145/800186.810616. Depth goes on as the plane.
/// @throws std::invalid_argument if the frame has no such instance, or parts of other sizes.
Background backgroundWithout(const RgbdImage& image, std::uint8_t instance);

}  // namespace conceptplan
