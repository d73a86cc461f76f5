#include "conceptplan/learner/visual_transition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/frame_composition.hpp"
#include "conceptplan/learner/frame_window.hpp"
#include "conceptplan/learner/torch/causal_transition.hpp"
#include "conceptplan/learner/torch/frame_synthesizer.hpp"
#include "conceptplan/learner/torch/generator_guard.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/torch/token_tensors.hpp"

namespace conceptplan {
namespace {

constexpr int kEdge = FrameWindow::kEdge;
constexpr std::size_t kWindows = 2;  // of a frame

/// Middle of the bounding box of the hole, pixels.
std::array<double, 2> middleOf(const std::vector<std::uint8_t>& hole, int width) {
  int left = width, right = -1, top = static_cast<int>(hole.size()), bottom = -1;
  for (std::size_t i = 0; i < hole.size(); ++i)
    if (hole[i] != 0) {
      const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  return {0.5 * (left + right), 0.5 * (top + bottom)};
}

/// How much a window counts at its pixel: falls to those of its edges that lie within the frame, so
/// that windows blend.
float windowWeight(int x, int y, WindowCorner corner, const RgbdImage& frame) {
  int margin = kEdge;
  if (corner.left > 0) margin = std::min(margin, x);
  if (corner.top > 0) margin = std::min(margin, y);
  if (corner.left + kEdge < frame.width) margin = std::min(margin, kEdge - 1 - x);
  if (corner.top + kEdge < frame.height) margin = std::min(margin, kEdge - 1 - y);
  return std::min(1.0F, static_cast<float>(margin + 1) / 12.0F);
}

/// One object that comes into one frame, through a window where the last one was and one where it
/// comes.
class FrameDrawing {
 public:
  explicit FrameDrawing(const SynthesisInput& input)
      : background_(input.background), instance_(input.instance) {
    const RgbdImage& frame = background_.image;
    check();
    seen_ = hiddenBehind(input.object, objectsDepth_mm(frame), frame.width);
    const auto old_place = middleOf(background_.hole, frame.width);
    const WindowCorner crop = cropCorner(seen_.location);
    const double half = DrawnObject::kEdge / 2.0;
    corners_ = {windowAround(old_place[0], old_place[1], frame.width, frame.height),
                windowAround(crop.left + half, crop.top + half, frame.width, frame.height)};
  }

  /// Writes [2, 8, 96, 96], what the synthesizer is given. @returns the end of it
  float* writePlanes(float* to) const {
    const RgbdImage& frame = background_.image;
    for (const WindowCorner& corner : corners_) {
      const FrameWindow window = cutWindow(frame.rgb, background_.hole, frame.width, corner, seen_);
      to = std::copy(window.planes.begin(), window.planes.end(), to);
    }
    return to;
  }

  /// The frame with both windows, which blend into each other and, over a thin margin, into it.
  /// @param colors [2, 3, 96, 96], what the synthesizer gives
  RgbdImage blended(const float* colors) const {
    RgbdImage image = background_.image;
    std::vector<float> sum(image.rgb.size(), 0.0F), weight(image.mask.size(), 0.0F);
    for (const WindowCorner& corner : corners_)
      for (int channel = 0; channel < 3; ++channel)
        for (int y = 0; y < kEdge; ++y)
          for (int x = 0; x < kEdge; ++x, ++colors) {
            const auto pixel =
                static_cast<std::size_t>((corner.top + y) * image.width + corner.left + x);
            const float share = windowWeight(x, y, corner, image);
            sum[3 * pixel + static_cast<std::size_t>(channel)] += share * *colors;
            if (channel == 0) weight[pixel] += share;
          }
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      const float total = weight[i / 3];
      if (total <= 0) continue;
      const float kept = std::max(0.0F, 1.0F - total) * static_cast<float>(image.rgb[i]) / 255.0F;
      const float value = (sum[i] + kept) / std::max(1.0F, total);
      image.rgb[i] = static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
    }
    placeInstance(image, instance_, seen_);
    return image;
  }

 private:
  void check() const {
    const RgbdImage& image = background_.image;
    const std::size_t size = background_.hole.size();
    if (image.width < kEdge || image.height < kEdge ||
        size != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) ||
        image.rgb.size() != 3 * size || image.depth_m.size() != size || image.mask.size() != size)
      throw std::invalid_argument("synthesize: a frame of " + std::to_string(image.width) + " x " +
                                  std::to_string(image.height) +
                                  " is smaller than a window or has parts of other sizes");
    if (instance_ == 0 ||
        std::find(image.mask.begin(), image.mask.end(), instance_) != image.mask.end())
      throw std::invalid_argument("synthesize: instance " + std::to_string(instance_) +
                                  " is no object or stands in the picture");
  }

  const Background& background_;
  std::uint8_t instance_;
  DrawnObject seen_;  ///< without what other objects hide
  std::array<WindowCorner, kWindows> corners_;
};

}  // namespace

struct VisualTransition::Networks {
  CausalTransition transition;
  FrameSynthesizer synthesizer;
  std::filesystem::path path;

  static std::unique_ptr<Networks> fresh(const std::filesystem::path& file) {
    const GeneratorGuard guard;
    return std::make_unique<Networks>(Networks{CausalTransition(), FrameSynthesizer(), file});
  }

  /// @throws InputError unless all numbers are finite.
  void check(const torch::Tensor& numbers, const char* key, const char* what) const {
    if (!torch::isfinite(numbers).all().item<bool>())
      throw InputError({{path.string(),
                         {},
                         {},
                         key,
                         std::string("the weights give ") + what + " that are not finite"}});
  }
};

VisualTransition::VisualTransition(const NamedTensors& tensors, const std::filesystem::path& path)
    : networks_(Networks::fresh(path)) {
  setTensors(*networks_->transition, tensors, "transition.", path);
  setTensors(*networks_->synthesizer, tensors, "synthesizer.", path);
  networks_->transition->eval();
  networks_->synthesizer->eval();
}

VisualTransition::~VisualTransition() = default;
VisualTransition::VisualTransition(VisualTransition&&) noexcept = default;
VisualTransition& VisualTransition::operator=(VisualTransition&&) noexcept = default;

std::vector<Tokens> VisualTransition::apply(std::span<const TransitionInput> inputs) const {
  if (inputs.empty()) return {};
  std::vector<Tokens> tokens, contexts;
  std::vector<std::int64_t> actions;
  for (const TransitionInput& input : inputs) {
    if (!input.tokens.allFinite() || !input.context.allFinite())
      throw std::invalid_argument("VisualTransition::apply: tokens or context are not finite");
    tokens.push_back(input.tokens);
    contexts.push_back(input.context);
    actions.push_back(static_cast<std::int64_t>(index(input.action)));
  }
  const torch::InferenceMode inference;
  const auto next = networks_->transition->forward(toTensor(tokens), toTensor(contexts),
                                                   torch::tensor(actions, torch::kLong));
  networks_->check(next, "transition", "tokens");
  return toTokens(next);
}

Tokens VisualTransition::apply(const Tokens& tokens, const Tokens& context, Action action) const {
  const TransitionInput input{tokens, context, action};
  return apply({&input, 1}).front();
}

std::vector<RgbdImage> VisualTransition::synthesize(std::span<const SynthesisInput> inputs) const {
  constexpr std::size_t kBatch = 16;
  const torch::InferenceMode inference;
  std::vector<RgbdImage> images;
  for (std::size_t begin = 0; begin < inputs.size(); begin += kBatch) {
    const auto batch = inputs.subspan(begin, std::min(kBatch, inputs.size() - begin));
    std::vector<FrameDrawing> drawings;
    for (const SynthesisInput& input : batch) drawings.emplace_back(input);
    auto planes =
        torch::empty({static_cast<std::int64_t>(kWindows * batch.size()), 8, kEdge, kEdge});
    auto* to = planes.data_ptr<float>();
    for (const FrameDrawing& drawing : drawings) to = drawing.writePlanes(to);
    const auto drawn = networks_->synthesizer
                           ->forward(planes.slice(1, 0, 3), planes.slice(1, 3, 4),
                                     planes.slice(1, 4, 7), planes.slice(1, 7, 8))
                           .contiguous();
    networks_->check(drawn, "synthesizer", "colours");
    const auto* colors = drawn.data_ptr<float>();
    for (const FrameDrawing& drawing : drawings) {
      images.push_back(drawing.blended(colors));
      colors += kWindows * 3 * FrameWindow::kPixels;
    }
  }
  return images;
}

RgbdImage VisualTransition::synthesize(const Background& background, std::uint8_t instance,
                                       const DrawnObject& object) const {
  const SynthesisInput input{background, instance, object};
  return std::move(synthesize({&input, 1}).front());
}

}  // namespace conceptplan
