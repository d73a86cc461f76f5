#pragma once

#include <cstdint>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"

namespace conceptplan {

/// What is believed of one object in a picture.
struct BelievedObject {
  const RgbdImage& image;
  std::uint8_t instance;
  const SymbolBelief& belief;
};

/// Whether two pictures of an object contradict the turn that its ROTATION symbols say, and that
/// turn and half a turn more much less. False where the model's `rotate_left` is no quarter turn,
/// or does not lead from the first symbol to the second.
bool isTurnedRound(const SymbolicModel& model, const BelievedObject& before,
                   const BelievedObject& after);

/// The belief with each ROTATION symbol replaced by the one half a turn on; the same where the
/// model's `rotate_left` is no quarter turn.
SymbolBelief turnedRound(const SymbolicModel& model, SymbolBelief belief);

}  // namespace conceptplan
