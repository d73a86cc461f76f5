#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/learner/background.hpp"
#include "conceptplan/learner/concept_learner.hpp"

namespace conceptplan {

/// An object before an action.
struct TransitionInput {
  Tokens tokens;
  Tokens context;  ///< that of `effectContext`
  Action action;
};

/// An object to be drawn into a frame.
struct SynthesisInput {
  const Background& background;
  std::uint8_t instance;  ///< id that it gets in the mask
  const DrawnObject& object;
};

/// The trained visual causal transition model (ViCT): what an action does to tokens, and the
/// picture of the workbench after it. Source: Sec. III-C of arXiv 2310.03325. Immutable; threads
/// may share it.
class VisualTransition {
 public:
  /// @param path stands in the faults. @throws InputError if tensors are missing or misshaped.
  VisualTransition(const NamedTensors& tensors, const std::filesystem::path& path);
  ~VisualTransition();
  VisualTransition(VisualTransition&&) noexcept;
  VisualTransition& operator=(VisualTransition&&) noexcept;

  /// C1' = T(C0, V(a)), Eq. (7), of each object, in order.
  /// @throws InputError if the weights give tokens that are not finite, std::invalid_argument if
  /// tokens or contexts are not.
  std::vector<Tokens> apply(std::span<const TransitionInput> inputs) const;
  Tokens apply(const Tokens& tokens, const Tokens& context, Action action) const;

  /// The picture, its depth and its mask with the object drawn as that instance, hidden where other
  /// objects stand before it; of each input, in order.
  /// @throws std::invalid_argument if a picture is smaller than a window of 96 x 96 or has parts
  /// of other sizes, or if an instance is 0 or among its objects, or an object's location is not
  /// finite. @throws InputError if the weights give colours that are not finite.
  std::vector<RgbdImage> synthesize(std::span<const SynthesisInput> inputs) const;
  RgbdImage synthesize(const Background& background, std::uint8_t instance,
                       const DrawnObject& object) const;

 private:
  struct Networks;
  std::unique_ptr<Networks> networks_;
};

}  // namespace conceptplan
