#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <vector>

#include "conceptplan/domain/concept.hpp"
#include "conceptplan/learner/encoder_kind.hpp"
#include "conceptplan/learner/torch/object_drawer.hpp"

namespace conceptplan {

inline constexpr std::int64_t kTokenWidth = 64;

/// The Substitution-based Concept Learner: encoder, concept tokenizer, concept detokenizer and
/// decoder. Source: Sec. III-A of arXiv 2310.03325 and, for the layers of `kFullFrame`, the
/// authors' page. Departures of `kObjectCentred`, each for what two CPU cores can learn: an
/// object's crop and its location for the whole frame; a perceptron as detokenizer; convolution and
/// pixel shuffle for transposed convolution. Both normalise tokens to a fixed length without
/// parameters, draw mask and depth beside colours, and say where the crop lies. What
/// `kObjectCentred` shows is drawn by an `ObjectDrawer`, which learns from the finished tokens; its
/// decoder only helps them to be learned.
class ConceptNetworkImpl : public torch::nn::Module {
 public:
  explicit ConceptNetworkImpl(EncoderKind encoder = EncoderKind::kObjectCentred);

  /// Latent embedding Z. planes [B, 5, 64, 64] (full frame: [B, 5, 256, 256], of which
  /// the mask is not read) in 0..1 -> [B, c, 8, 8] with c = 96 (full frame: 64).
  torch::Tensor encode(const torch::Tensor& planes);

  /// Concept tokens C. z [B, c, 8, 8], location [B, 3], not read of full frames -> [B, 6, 64], each
  /// of length 8.
  torch::Tensor tokenize(const torch::Tensor& z, const torch::Tensor& location);

  /// Latent embedding Z'. tokens [B, 6, 64] -> [B, c, 8, 8].
  torch::Tensor detokenize(const torch::Tensor& tokens);

  /// z [B, c, 8, 8] -> the object's picture.
  DecodedObject decode(const torch::Tensor& z);

  /// The object's picture to be shown: that of the drawer, in the box that it finds, or of a full
  /// frame `decode(detokenize)`. tokens [B, 6, 64].
  DecodedObject draw(const torch::Tensor& tokens);

  /// Draws what `draw` shows; empty for a full frame.
  ObjectDrawer& drawer() { return drawer_; }

  /// Where the object's crop lies. tokens [B, 6, 64] -> [B, 3], as `EncoderInput::location`.
  torch::Tensor locate(const torch::Tensor& tokens);

  /// Logits of each token for the prototypes of a concept. tokens [B, 6, 64] -> [B, values].
  torch::Tensor prototypeLogits(const torch::Tensor& tokens, Concept which) const;

  /// [values, 64]
  const torch::Tensor& prototypes(Concept which) const { return prototypes_[index(which)]; }

  EncoderKind encoderKind() const { return encoder_kind_; }

 private:
  EncoderKind encoder_kind_;
  torch::nn::Sequential encoder_{nullptr};
  torch::nn::Sequential location_embedding_{nullptr};
  torch::Tensor concept_queries_;  // [6, 64]
  torch::Tensor positions_;        // [64, 64]: one embedding a cell of Z
  torch::nn::Linear image_tokens_{nullptr};
  torch::nn::ModuleList tokenizer_layers_{nullptr};
  torch::nn::Linear to_tokens_{nullptr};
  torch::nn::Sequential detokenizer_{nullptr};
  torch::nn::Sequential detokenizer_upsampling_{nullptr};
  torch::Tensor image_queries_;  // [64, 64]: one query a cell of Z'; full frame
  torch::nn::ModuleList detokenizer_layers_{nullptr};
  torch::nn::Linear to_latent_{nullptr};
  torch::nn::Sequential decoder_{nullptr};
  torch::nn::Sequential locator_{nullptr};
  std::vector<torch::Tensor> prototypes_;  // a concept: [values, 64]
  ObjectDrawer drawer_{nullptr};
};
TORCH_MODULE(ConceptNetwork);

}  // namespace conceptplan
