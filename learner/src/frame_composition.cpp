#include "conceptplan/learner/frame_composition.hpp"

#include <algorithm>
#include <cmath>

#include "conceptplan/learner/frame_window.hpp"

namespace conceptplan {
namespace {

constexpr int kCrop = DrawnObject::kEdge;
constexpr float kVisible = 0.5F;
/// Depths are drawn to some millimetres only.
constexpr float kDepthTolerance_m = 0.008F;

/// Calls visit(pixel of the object's planes, pixel of the frame) for those inside the frame.
template <typename Visit>
void forEachPixel(const DrawnObject& object, int width, int height, Visit visit) {
  const WindowCorner crop = cropCorner(object.location);
  for (int y = std::max(0, -crop.top); y < std::min(kCrop, height - crop.top); ++y)
    for (int x = std::max(0, -crop.left); x < std::min(kCrop, width - crop.left); ++x)
      visit(static_cast<std::size_t>(y * kCrop + x),
            static_cast<std::size_t>((crop.top + y) * width + crop.left + x));
}

}  // namespace

std::vector<std::uint16_t> objectsDepth_mm(const RgbdImage& image) {
  std::vector<std::uint16_t> objects(image.mask.size(), 0);
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (image.mask[i] != 0)
      objects[i] = static_cast<std::uint16_t>(
          std::lround(std::clamp(1000.0F * image.depth_m[i], 0.0F, 65535.0F)));
  return objects;
}

DrawnObject hiddenBehind(DrawnObject object, std::span<const std::uint16_t> others_mm, int width) {
  const int height = static_cast<int>(others_mm.size()) / width;
  forEachPixel(object, width, height, [&](std::size_t drawn, std::size_t pixel) {
    const float other_m = 0.001F * static_cast<float>(others_mm[pixel]);
    if (other_m > 0 && other_m < object.depth_m[drawn] - kDepthTolerance_m) object.alpha[drawn] = 0;
  });
  return object;
}

void placeInstance(RgbdImage& image, std::uint8_t instance, const DrawnObject& object) {
  forEachPixel(object, image.width, image.height, [&](std::size_t drawn, std::size_t pixel) {
    if (object.alpha[drawn] < kVisible) return;
    image.mask[pixel] = instance;
    image.depth_m[pixel] = object.depth_m[drawn];
  });
}

}  // namespace conceptplan
