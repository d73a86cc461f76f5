#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/learner/background.hpp"
#include "conceptplan/learner/concept_learner.hpp"

namespace conceptplan {

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

  /// C1' = T(C0, V(a)), Eq. (7). `context` is that of `effectContext`.
  /// @throws InputError if the weights give tokens that are not finite, std::invalid_argument if
  /// `tokens` or `context` are not.
  Tokens apply(const Tokens& tokens, const Tokens& context, Action action) const;

  /// The picture, its depth and its mask with the object drawn as that instance, hidden where other
  /// objects stand before it.
  /// @throws std::invalid_argument if the picture is smaller than a window of 96 x 96 or has parts
  /// of other sizes, or if the instance is 0 or among its objects, or the object's location is not
  /// finite. @throws InputError if the weights give colours that are not finite.
  RgbdImage synthesize(const Background& background, std::uint8_t instance,
                       const DrawnObject& object) const;

 private:
  struct Networks;
  std::unique_ptr<Networks> networks_;
};

}  // namespace conceptplan
