#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "conceptplan/domain/object_crop.hpp"

namespace conceptplan {

/// One object as the encoder sees it: its crop as bytes and where the crop lies in the frame.
struct EncoderInput {
  static constexpr int kEdge = ObjectCrop::kEdge;
  static constexpr int kPixels = kEdge * kEdge;
  static constexpr int kChannels = 5;  ///< red, green, blue, relative depth, mask
  static constexpr int kDepthPlane = 3;
  static constexpr int kMaskPlane = 4;

  /// [5, 64, 64]. Depth is relative to the object's median, 1 mm a level, 128 at the median,
  /// clipped; 0 outside the mask. The mask is 0 or 255.
  std::vector<std::uint8_t> planes;

  /// Column and row of the crop's centre, from -1 to 1 over the frame, and the median depth of
  /// the object in units of 0.5 m from 2 m.
  std::array<float, 3> location{};
};

/// Column and row of the frame at which the crop's centre lies, in pixels.
Eigen::Vector2d pixelOf(const std::array<float, 3>& location);

/// Metres along the camera's axis of a level of the depth plane, 0 to 255, at that location.
float depthOf(const std::array<float, 3>& location, float level);

/// The bytes of a crop. @throws std::invalid_argument if its planes are not 64 x 64 or no pixel is
/// on the object.
EncoderInput encoderInput(const ObjectCrop& crop);

}  // namespace conceptplan
