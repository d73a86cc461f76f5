#include "conceptplan/domain/rendering/appearance.hpp"

namespace conceptplan {

int colorSample(const Appearance& appearance, std::size_t object) {
  return static_cast<int>((appearance.seed % kColorSamples + 7 * object) % kColorSamples);
}

}  // namespace conceptplan
