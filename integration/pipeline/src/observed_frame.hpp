#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/encoder_input.hpp"

namespace conceptplan {

/// The objects of one picture.
struct ObservedFrame {
  std::vector<std::uint8_t> instances;  ///< ids in the mask, ascending
  std::vector<EncoderInput> inputs;     ///< of each instance
  std::vector<Tokens> tokens;           ///< of each instance

  /// Position of an instance, or `instances.size()`.
  std::size_t position(std::uint8_t instance) const;
};

/// Cuts out every object of the pictures and encodes them together.
std::vector<ObservedFrame> observeFrames(const ConceptLearner& learner,
                                         std::span<const RgbdImage> images);

}  // namespace conceptplan
