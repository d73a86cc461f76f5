#pragma once

#include <cstdint>
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

/// Cuts out and encodes every object of a picture.
ObservedFrame observeFrame(const ConceptLearner& learner, const RgbdImage& image);

}  // namespace conceptplan
