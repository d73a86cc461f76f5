#include "conceptplan/domain/object_crop.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace conceptplan {

ObjectCrop cropObject(const RgbdImage& image, std::uint8_t instance) {
  int left = image.width, right = -1, top = image.height, bottom = -1;
  if (instance != 0) {
    for (int y = 0; y < image.height; ++y) {
      const auto* row = image.mask.data() + static_cast<std::ptrdiff_t>(y) * image.width;
      for (int x = 0; x < image.width; ++x) {
        if (row[x] != instance) continue;
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = y;
      }
    }
  }
  if (right < 0) {
    throw std::invalid_argument("cropObject: no pixel of the mask has instance id " +
                                std::to_string(instance));
  }
  constexpr int kEdge = ObjectCrop::kEdge;
  ObjectCrop crop;
  crop.rgb.resize(3 * kEdge * kEdge);
  crop.depth_m.resize(kEdge * kEdge);
  crop.mask.resize(kEdge * kEdge);
  crop.left = (left + right + 1) / 2 - kEdge / 2;
  crop.top = (top + bottom + 1) / 2 - kEdge / 2;
  for (int y = std::max(top, crop.top); y <= std::min(bottom, crop.top + kEdge - 1); ++y) {
    for (int x = std::max(left, crop.left); x <= std::min(right, crop.left + kEdge - 1); ++x) {
      const auto from = static_cast<std::size_t>(y) * image.width + x;
      if (image.mask[from] != instance) continue;
      const auto to = static_cast<std::size_t>(y - crop.top) * kEdge + (x - crop.left);
      std::copy_n(&image.rgb[3 * from], 3, &crop.rgb[3 * to]);
      crop.depth_m[to] = image.depth_m[from];
      crop.mask[to] = 1;
    }
  }
  return crop;
}

}  // namespace conceptplan
