#pragma once

#include <cstdint>
#include <vector>

namespace conceptplan {

/// One RGB-D picture with its instance mask, row-major from the top left.
struct RgbdImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;   ///< [height, width, 3], sRGB
  std::vector<float> depth_m;      ///< [height, width], along the camera axis; 0 where unknown
  std::vector<std::uint8_t> mask;  ///< [height, width], instance id; 0 is the background
};

/// Every frame is 384 x 256. Source: Sec. II of arXiv 2310.03325.
inline constexpr int kFrameWidth = 384;
inline constexpr int kFrameHeight = 256;

}  // namespace conceptplan
