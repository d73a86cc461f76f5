#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "conceptplan/domain/image.hpp"

namespace conceptplan::report {

/// Where one instance of a mask lies in its picture, in pixels.
struct Outline {
  std::uint8_t instance = 0;
  std::string path;  ///< closed SVG path data around every part of the instance
  double center_x = 0;
  double top = 0;
};

/// The outline of each instance of the mask, in order of their ids. Corners are cut through the
/// middles of the pixels' edges, which smooths the staircase.
/// @pre the mask is [height, width]
std::vector<Outline> outlines(const RgbdImage& image);

}  // namespace conceptplan::report
