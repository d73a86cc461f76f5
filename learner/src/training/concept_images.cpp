#include "conceptplan/learner/training/concept_images.hpp"

#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {
constexpr std::size_t kBytes =
    static_cast<std::size_t>(EncoderInput::kChannels) * EncoderInput::kPixels;
}

ConceptValues conceptValues(const ObjectState& object) {
  if (static_cast<std::size_t>(object.type) >= kNumSeenTypes)
    throw std::invalid_argument("conceptValues: " + std::string(name(object.type)) +
                                " is not a type of the concept set");
  return {static_cast<std::uint8_t>(object.type),   static_cast<std::uint8_t>(object.cell.x),
          static_cast<std::uint8_t>(object.cell.y), static_cast<std::uint8_t>(object.rotation),
          static_cast<std::uint8_t>(object.color),  static_cast<std::uint8_t>(object.size)};
}

void ConceptImages::add(const EncoderInput& input, const ConceptValues& values) {
  if (input.planes.size() != kBytes)
    throw std::invalid_argument("ConceptImages::add: expected " + std::to_string(kBytes) +
                                " bytes, found " + std::to_string(input.planes.size()));
  planes_.insert(planes_.end(), input.planes.begin(), input.planes.end());
  locations_.push_back(input.location);
  values_.push_back(values);
}

std::span<const std::uint8_t> ConceptImages::planes(std::size_t image) const {
  return std::span(planes_).subspan(image * kBytes, kBytes);
}

}  // namespace conceptplan
