#pragma once

#include <cstddef>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/learner/training/task_sequences.hpp"

namespace conceptplan {

/// A grey frame with a dark square, which stands for the object, as tests of ViCT see pictures.
inline SequenceFrame squareFrame(int left, const Tokens& tokens) {
  constexpr std::size_t kPixels = kFrameWidth * kFrameHeight;
  SequenceFrame frame;
  frame.rgb.assign(3 * kPixels, 160);
  frame.floor_rgb = frame.rgb;
  frame.hole.assign(kPixels, 0);
  frame.others_mm.assign(kPixels, 0);
  for (int y = 100; y < 130; ++y)
    for (int x = left; x < left + 30; ++x) {
      const auto pixel = static_cast<std::size_t>(y * kFrameWidth + x);
      frame.hole[pixel] = 1;
      for (std::size_t channel = 0; channel < 3; ++channel) frame.rgb[3 * pixel + channel] = 40;
    }
  frame.x_px = left + 15;
  frame.y_px = 115;
  frame.tokens = tokens;
  return frame;
}

}  // namespace conceptplan
