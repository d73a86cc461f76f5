#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "conceptplan/learner/encoder_input.hpp"
#include "conceptplan/learner/encoder_kind.hpp"
#include "conceptplan/learner/tensor_file.hpp"
#include "conceptplan/learner/tokens.hpp"

namespace conceptplan {

/// An object as it is drawn from tokens.
struct DrawnObject {
  static constexpr int kEdge = EncoderInput::kEdge;
  std::vector<float> rgb;           ///< [3, 64, 64], 0 to 1
  std::vector<float> alpha;         ///< [64, 64], opacity, 0 to 1
  std::vector<float> depth_m;       ///< [64, 64], along the camera's axis; holds where alpha is 1
  std::array<float, 3> location{};  ///< as `EncoderInput::location`
};

/// The trained concept learner: pictures of objects to concept tokens, and back. Immutable after
/// construction; threads may share it, each call uses the caller's Torch thread settings.
class ConceptLearner {
 public:
  /// @param path stands in the faults. @throws InputError if tensors are missing or misshaped.
  ConceptLearner(const NamedTensors& tensors, EncoderKind encoder,
                 const std::filesystem::path& path);
  ~ConceptLearner();
  ConceptLearner(ConceptLearner&&) noexcept;
  ConceptLearner& operator=(ConceptLearner&&) noexcept;

  /// The tokens of each object, in order. @throws InputError if the weights give none that are
  /// finite, std::invalid_argument if an object's location is not finite.
  std::vector<Tokens> encode(std::span<const EncoderInput> inputs) const;

  /// Each object as its tokens describe it, in order; far outside the frame at most 100 half
  /// frames.
  /// @throws InputError if the weights give numbers that are not finite, std::invalid_argument if
  /// tokens are not.
  std::vector<DrawnObject> draw(std::span<const Tokens> tokens) const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace conceptplan
