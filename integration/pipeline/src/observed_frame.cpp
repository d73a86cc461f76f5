#include "observed_frame.hpp"

#include <algorithm>
#include <array>

#include "conceptplan/domain/object_crop.hpp"

namespace conceptplan {

std::size_t ObservedFrame::position(std::uint8_t instance) const {
  return static_cast<std::size_t>(std::find(instances.begin(), instances.end(), instance) -
                                  instances.begin());
}

std::vector<ObservedFrame> observeFrames(const ConceptLearner& learner,
                                         std::span<const RgbdImage> images) {
  std::vector<ObservedFrame> frames;
  std::vector<EncoderInput> inputs;
  for (const RgbdImage& image : images) {
    std::array<bool, 256> present{};
    for (const std::uint8_t id : image.mask) present[id] = true;
    ObservedFrame& frame = frames.emplace_back();
    for (std::size_t id = 1; id < present.size(); ++id) {
      if (!present[id]) continue;
      const auto instance = static_cast<std::uint8_t>(id);
      frame.instances.push_back(instance);
      frame.inputs.push_back(encoderInput(cropObject(image, instance)));
    }
    inputs.insert(inputs.end(), frame.inputs.begin(), frame.inputs.end());
  }
  const std::vector<Tokens> tokens = learner.encode(inputs);
  auto next = tokens.begin();
  for (ObservedFrame& frame : frames) {
    const auto last = next + static_cast<std::ptrdiff_t>(frame.inputs.size());
    frame.tokens.assign(next, last);
    next = last;
  }
  return frames;
}

}  // namespace conceptplan
