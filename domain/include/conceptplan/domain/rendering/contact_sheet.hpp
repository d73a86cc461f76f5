#pragma once

#include <cstdint>
#include <vector>

#include "conceptplan/domain/object.hpp"
#include "conceptplan/domain/rendering/appearance.hpp"
#include "conceptplan/domain/rendering/renderer.hpp"

namespace conceptplan {

/// A colour picture, row-major from the top left.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< [height, width, 3], sRGB
};

struct ContactSheetOptions {
  Appearance appearance;
  int scale = 2;  ///< edge of a rendered pixel on the sheet, in [1, 8]
};

/// Every object type, a row each, in its four quarter turns: the largest size on the middle cell.
/// Rows and columns are labelled; neighbouring rows differ in colour.
/// @throws std::invalid_argument if the scale is out of its range
Picture rotationSheet(Renderer& renderer, const ContactSheetOptions& options = {});

/// One object type in the six colours, a row each, and the four sizes.
/// @throws std::invalid_argument as `rotationSheet`
Picture colorAndSizeSheet(Renderer& renderer, ObjectType type,
                          const ContactSheetOptions& options = {});

}  // namespace conceptplan
