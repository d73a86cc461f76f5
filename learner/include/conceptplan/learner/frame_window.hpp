#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/learner/concept_learner.hpp"

namespace conceptplan {

/// A square of a frame, as the frame synthesizer takes it.
struct FrameWindow {
  static constexpr int kEdge = 96;
  static constexpr int kPixels = kEdge * kEdge;
  int left = 0;               ///< column of the first pixel, within the frame
  int top = 0;                ///< row of the first pixel, within the frame
  std::vector<float> planes;  ///< [8, 96, 96]: floor, hole, object, alpha; 0 to 1
};

/// The first pixel of a window.
struct WindowCorner {
  int left = 0;
  int top = 0;
};

/// The corner of the window that is nearest to being centred at a pixel, which may lie outside, of
/// a frame of that size. @throws std::invalid_argument if the frame is smaller than a window or the
/// pixel's coordinates are not finite.
WindowCorner windowAround(double x, double y, int width, int height);

/// Corner of the crop of an object at that location, seen or drawn, in pixels of the frame; at most
/// a million off. @throws std::invalid_argument if the location is not finite.
WindowCorner cropCorner(const std::array<float, 3>& location);

/// The window of a frame: the floor, where the hole was, and the object that comes over it.
/// rgb [height, width, 3] and hole [height, width] as of `Background`.
FrameWindow cutWindow(std::span<const std::uint8_t> rgb, std::span<const std::uint8_t> hole,
                      int width, WindowCorner corner, const DrawnObject& object);

}  // namespace conceptplan
