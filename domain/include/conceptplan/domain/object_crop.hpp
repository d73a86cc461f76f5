#pragma once

#include <cstdint>
#include <vector>

#include "conceptplan/domain/image.hpp"

namespace conceptplan {

/// The pixels of one object at native resolution, centred on the bounding box of its mask; all
/// else is black. What the concept learner sees of an object.
struct ObjectCrop {
  static constexpr int kEdge = 64;  ///< pixels

  std::vector<std::uint8_t> rgb;   ///< [64, 64, 3]
  std::vector<float> depth_m;      ///< [64, 64]; 0 outside the mask
  std::vector<std::uint8_t> mask;  ///< [64, 64]; 1 on the object
  int left = 0;                    ///< column of the crop's first pixel in the frame; may be < 0
  int top = 0;                     ///< row of the crop's first pixel in the frame; may be < 0
};

/// The crop of an instance. An object larger than the crop is cut at its edges.
/// @throws std::invalid_argument if no pixel of the mask has that id, or it is 0.
ObjectCrop cropObject(const RgbdImage& image, std::uint8_t instance);

}  // namespace conceptplan
