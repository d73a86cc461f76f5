#include "observed_frame.hpp"

#include <algorithm>
#include <array>

#include "conceptplan/domain/object_crop.hpp"

namespace conceptplan {

std::size_t ObservedFrame::position(std::uint8_t instance) const {
  return static_cast<std::size_t>(std::find(instances.begin(), instances.end(), instance) -
                                  instances.begin());
}

ObservedFrame observeFrame(const ConceptLearner& learner, const RgbdImage& image) {
  std::array<bool, 256> present{};
  for (const std::uint8_t id : image.mask) present[id] = true;
  ObservedFrame frame;
  for (std::size_t id = 1; id < present.size(); ++id) {
    if (!present[id]) continue;
    const auto instance = static_cast<std::uint8_t>(id);
    frame.instances.push_back(instance);
    frame.inputs.push_back(encoderInput(cropObject(image, instance)));
  }
  frame.tokens = learner.encode(frame.inputs);
  return frame;
}

}  // namespace conceptplan
