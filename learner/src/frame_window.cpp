#include "conceptplan/learner/frame_window.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {
constexpr int kEdge = FrameWindow::kEdge;
constexpr double kFarthest_px = 1e6;

/// The whole number next to a pixel, no farther away than any frame reaches.
int wholePixel(double pixel) {
  return static_cast<int>(std::lround(std::clamp(pixel, -kFarthest_px, kFarthest_px)));
}

}  // namespace

WindowCorner windowAround(double x, double y, int width, int height) {
  if (width < kEdge || height < kEdge)
    throw std::invalid_argument("windowAround: a frame of " + std::to_string(width) + " x " +
                                std::to_string(height) + " is smaller than a window");
  if (!std::isfinite(x) || !std::isfinite(y))
    throw std::invalid_argument("windowAround: no pixel lies at " + std::to_string(x) + ", " +
                                std::to_string(y));
  return {std::clamp(wholePixel(x) - kEdge / 2, 0, width - kEdge),
          std::clamp(wholePixel(y) - kEdge / 2, 0, height - kEdge)};
}

WindowCorner cropCorner(const std::array<float, 3>& location) {
  const Eigen::Vector2d centre = pixelOf(location);
  if (!centre.allFinite())
    throw std::invalid_argument("cropCorner: the object lies at " + std::to_string(centre.x()) +
                                ", " + std::to_string(centre.y()));
  return {wholePixel(centre.x()) - ObjectCrop::kEdge / 2,
          wholePixel(centre.y()) - ObjectCrop::kEdge / 2};
}

FrameWindow cutWindow(std::span<const std::uint8_t> rgb, std::span<const std::uint8_t> hole,
                      int width, WindowCorner corner, const DrawnObject& object) {
  constexpr int kPixels = FrameWindow::kPixels;
  constexpr int kCrop = DrawnObject::kEdge;
  FrameWindow window{corner.left, corner.top, std::vector<float>(8 * kPixels, 0.0F)};
  const WindowCorner crop = cropCorner(object.location);
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x) {
      const int pixel = y * kEdge + x;
      const auto source = static_cast<std::size_t>((corner.top + y) * width + corner.left + x);
      for (int channel = 0; channel < 3; ++channel)
        window.planes[channel * kPixels + pixel] =
            static_cast<float>(rgb[3 * source + channel]) / 255.0F;
      window.planes[3 * kPixels + pixel] = hole[source] != 0 ? 1.0F : 0.0F;
      const int crop_x = corner.left + x - crop.left, crop_y = corner.top + y - crop.top;
      if (crop_x < 0 || crop_x >= kCrop || crop_y < 0 || crop_y >= kCrop) continue;
      const int drawn = crop_y * kCrop + crop_x;
      for (int channel = 0; channel < 3; ++channel)
        window.planes[(4 + channel) * kPixels + pixel] =
            object.rgb[channel * kCrop * kCrop + drawn];
      window.planes[7 * kPixels + pixel] = object.alpha[drawn];
    }
  return window;
}

}  // namespace conceptplan
