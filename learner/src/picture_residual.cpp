#include "conceptplan/learner/picture_residual.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "conceptplan/learner/frame_window.hpp"

namespace conceptplan {
namespace {

constexpr int kEdge = EncoderInput::kEdge;
constexpr int kPixels = EncoderInput::kPixels;
constexpr float kOpaque = 0.5F;
constexpr double kFarthest_m = 0.05;

void checkSizes(const EncoderInput& seen, const DrawnObject& drawn,
                std::span<const std::uint8_t> hidden) {
  if (seen.planes.size() != EncoderInput::kChannels * kPixels || drawn.rgb.size() != 3 * kPixels ||
      drawn.alpha.size() != kPixels || drawn.depth_m.size() != kPixels ||
      (!hidden.empty() && hidden.size() != kPixels))
    throw std::invalid_argument("pictureResidual: expected planes of 64 x 64");
}

}  // namespace

bool PictureResidual::within(const PictureResidual& limits) const {
  return silhouette <= limits.silhouette && depth_m <= limits.depth_m && color <= limits.color;
}

PictureResidual pictureResidual(const EncoderInput& seen, const DrawnObject& drawn,
                                std::span<const std::uint8_t> hidden) {
  checkSizes(seen, drawn, hidden);
  const WindowCorner from = cropCorner(seen.location), to = cropCorner(drawn.location);
  double seen_pixels = 0, alone = 0, color = 0, depth_sum_m = 0;
  std::vector<double> depth_m;  // differences, where both are
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x) {
      const int drawn_x = from.left + x - to.left, drawn_y = from.top + y - to.top;
      const bool in_crop = drawn_x >= 0 && drawn_x < kEdge && drawn_y >= 0 && drawn_y < kEdge;
      const auto there = static_cast<std::size_t>(in_crop ? drawn_y * kEdge + drawn_x : 0);
      const auto here = static_cast<std::size_t>(y * kEdge + x);
      const bool is_seen = seen.planes[EncoderInput::kMaskPlane * kPixels + here] != 0;
      const bool is_drawn = in_crop && drawn.alpha[there] >= kOpaque;
      const bool may_be_hidden = !hidden.empty() && hidden[here] != 0;
      if (is_seen) ++seen_pixels;
      if (is_seen ? !is_drawn : is_drawn && !may_be_hidden) ++alone;
      if (!is_seen || !is_drawn) continue;
      depth_m.push_back(
          depthOf(seen.location, seen.planes[EncoderInput::kDepthPlane * kPixels + here]) -
          drawn.depth_m[there]);
      depth_sum_m += depth_m.back();
      for (std::size_t channel = 0; channel < 3; ++channel)
        color += std::abs(seen.planes[channel * kPixels + here] / 255.0 -
                          drawn.rgb[channel * kPixels + there]);
    }
  if (seen_pixels == 0)
    throw std::invalid_argument("pictureResidual: no pixel of the crop is on the object");
  const double common = static_cast<double>(depth_m.size());
  if (common == 0) return {alone / seen_pixels, kFarthest_m, 1};
  PictureResidual residual{alone / seen_pixels, 0, color / (3 * common)};
  for (const double one_m : depth_m)
    residual.depth_m += std::min(kFarthest_m, std::abs(one_m - depth_sum_m / common)) / common;
  return residual;
}

std::vector<std::uint8_t> hiddenPixels(const RgbdImage& image, std::uint8_t instance,
                                       const EncoderInput& seen) {
  const WindowCorner corner = cropCorner(seen.location);
  std::vector<std::uint8_t> hidden(kPixels, 1);
  for (int y = std::max(0, -corner.top); y < std::min(kEdge, image.height - corner.top); ++y)
    for (int x = std::max(0, -corner.left); x < std::min(kEdge, image.width - corner.left); ++x) {
      const std::uint8_t id =
          image.mask[static_cast<std::size_t>((corner.top + y) * image.width + corner.left + x)];
      hidden[static_cast<std::size_t>(y * kEdge + x)] = id != 0 && id != instance ? 1 : 0;
    }
  return hidden;
}

}  // namespace conceptplan
