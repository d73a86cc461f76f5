#include "conceptplan/learner/training/concept_images.hpp"

#include <stdexcept>
#include <string>

#include "conceptplan/domain/files/checksum.hpp"

namespace conceptplan {
namespace {
constexpr std::size_t kBytes =
    static_cast<std::size_t>(EncoderInput::kChannels) * EncoderInput::kPixels;

template <typename Element>
std::string checksumOf(const std::vector<Element>& elements) {
  return hexadecimal(
      crc32({reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element)}));
}

}  // namespace

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

std::uint32_t ConceptImages::checksum() const {
  return crc32(checksumOf(planes_) + checksumOf(locations_) + checksumOf(values_));
}

std::span<const std::uint8_t> ConceptImages::planes(std::size_t image) const {
  return std::span(planes_).subspan(image * kBytes, kBytes);
}

}  // namespace conceptplan
