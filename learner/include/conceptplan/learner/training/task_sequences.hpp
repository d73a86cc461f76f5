#pragma once

#include <cstdint>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/learner/tokens.hpp"

namespace conceptplan {

/// One picture of a training task as ViCT needs it.
struct SequenceFrame {
  std::vector<std::uint8_t> rgb;         ///< [256, 384, 3]
  std::vector<std::uint8_t> floor_rgb;   ///< [256, 384, 3] without the target, see `Background`
  std::vector<std::uint8_t> hole;        ///< [256, 384], 1 where the target hid the floor
  std::vector<std::uint16_t> others_mm;  ///< [256, 384] without the target, see `objectsDepth_mm`
  double x_px = 0;                       ///< middle of the target's crop
  double y_px = 0;
  Tokens tokens;  ///< of the target
};

/// The pictures of one training task, in order, and the actions between them.
struct TaskSequence {
  std::vector<SequenceFrame> frames;
  std::vector<Action> actions;   ///< [frames - 1]
  std::vector<Tokens> contexts;  ///< [frames - 1], see `effectContext`
};

}  // namespace conceptplan
