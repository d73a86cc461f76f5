#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "conceptplan/domain/concept.hpp"
#include "conceptplan/domain/object.hpp"
#include "conceptplan/learner/encoder_input.hpp"

namespace conceptplan {

/// The value of each concept of one image: 0-based, in the order of `Concept`.
using ConceptValues = std::array<std::uint8_t, kNumConcepts>;

/// @throws std::invalid_argument for an object of an unseen type.
ConceptValues conceptValues(const ObjectState& object);

/// Foreground images of single objects, packed in memory, with the values that they show. Training
/// uses the values only to find images that differ in one concept.
class ConceptImages {
 public:
  void add(const EncoderInput& input, const ConceptValues& values);

  std::size_t size() const { return values_.size(); }
  std::span<const std::uint8_t> planes(std::size_t image) const;  ///< [5, 64, 64]
  const std::array<float, 3>& location(std::size_t image) const { return locations_[image]; }
  const ConceptValues& values(std::size_t image) const { return values_[image]; }

  /// CRC-32 of all images, where they lie and what they show, in order.
  std::uint32_t checksum() const;

 private:
  std::vector<std::uint8_t> planes_;
  std::vector<std::array<float, 3>> locations_;
  std::vector<ConceptValues> values_;
};

}  // namespace conceptplan
