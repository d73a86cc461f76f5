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
  const WindowCorner crop = cropCorner(object);
  for (int y = std::max(0, -crop.top); y < std::min(kCrop, height - crop.top); ++y)
    for (int x = std::max(0, -crop.left); x < std::min(kCrop, width - crop.left); ++x)
      visit(static_cast<std::size_t>(y * kCrop + x),
            static_cast<std::size_t>((crop.top + y) * width + crop.left + x));
}

/// Continues the background of one row across the pixels of an instance.
void fillRow(std::span<float> depth_m, std::span<const std::uint8_t> mask, std::uint8_t instance) {
  const auto width = static_cast<int>(mask.size());
  const auto background = [&](int from, int step) {
    int x = from;
    while (x >= 0 && x < width &&
           (mask[static_cast<std::size_t>(x)] != 0 || !(depth_m[static_cast<std::size_t>(x)] > 0)))
      x += step;
    return x >= 0 && x < width ? x : -1;
  };
  for (int x = 0; x < width; ++x) {
    if (mask[static_cast<std::size_t>(x)] != instance) continue;
    const int left = background(x, -1), right = background(x, 1);
    const auto inverse = [&](int at) { return 1.0F / depth_m[static_cast<std::size_t>(at)]; };
    float value = 0;
    if (left >= 0 && right >= 0) {
      const float share = static_cast<float>(x - left) / static_cast<float>(right - left);
      value = 1.0F / (inverse(left) + share * (inverse(right) - inverse(left)));
    } else if (left >= 0 || right >= 0) {
      value = 1.0F / inverse(std::max(left, right));
    }
    depth_m[static_cast<std::size_t>(x)] = value;
  }
}

}  // namespace

std::vector<std::uint16_t> othersDepth_mm(const RgbdImage& image, std::uint8_t instance) {
  std::vector<std::uint16_t> others(image.mask.size(), 0);
  for (std::size_t i = 0; i < others.size(); ++i)
    if (image.mask[i] != 0 && image.mask[i] != instance)
      others[i] = static_cast<std::uint16_t>(
          std::lround(std::clamp(1000.0F * image.depth_m[i], 0.0F, 65535.0F)));
  return others;
}

DrawnObject hiddenBehind(DrawnObject object, std::span<const std::uint16_t> others_mm, int width) {
  const int height = static_cast<int>(others_mm.size()) / width;
  forEachPixel(object, width, height, [&](std::size_t drawn, std::size_t pixel) {
    const float other_m = 0.001F * static_cast<float>(others_mm[pixel]);
    if (other_m > 0 && other_m < object.depth_m[drawn] - kDepthTolerance_m) object.alpha[drawn] = 0;
  });
  return object;
}

void moveInstance(RgbdImage& image, std::uint8_t instance, const DrawnObject& object) {
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const auto row = std::span(image.mask).subspan(y * width, width);
    fillRow(std::span(image.depth_m).subspan(y * width, width), row, instance);
    std::replace(row.begin(), row.end(), instance, std::uint8_t{0});
  }
  forEachPixel(object, image.width, image.height, [&](std::size_t drawn, std::size_t pixel) {
    if (object.alpha[drawn] < kVisible) return;
    image.mask[pixel] = instance;
    image.depth_m[pixel] = object.depth_m[drawn];
  });
}

}  // namespace conceptplan
