#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <vector>

#include "conceptplan/domain/concept.hpp"
#include "conceptplan/learner/encoder_kind.hpp"

namespace conceptplan {

inline constexpr std::int64_t kTokenWidth = 64;

/// Colour, mask and relative depth of an object, as the decoder draws them.
struct DecodedObject {
  torch::Tensor rgb;          ///< [B, 3, 64, 64], 0 to 1
  torch::Tensor mask_logits;  ///< [B, 1, 64, 64]
  torch::Tensor depth;        ///< [B, 1, 64, 64], 0 to 1, as the depth plane of `EncoderInput`
};

/// The Substitution-based Concept Learner: encoder, concept tokenizer, concept detokenizer and
/// decoder. Source: Sec. III-A of arXiv 2310.03325. Departures, each for what two CPU cores can
/// learn: object-centred input by default; tokens are normalised to a fixed length without
/// parameters; the detokenizer is a perceptron; up-sampling is convolution and pixel shuffle; the
/// decoder draws the object's crop, mask and depth, and says where the crop lies.
class ConceptNetworkImpl : public torch::nn::Module {
 public:
  explicit ConceptNetworkImpl(EncoderKind encoder = EncoderKind::kObjectCentred);

  /// Latent embedding Z. planes [B, 5, 64, 64] (full frame: [B, 4, 256, 256]) in 0..1
  /// -> [B, 96, 8, 8].
  torch::Tensor encode(const torch::Tensor& planes);

  /// Concept tokens C. z [B, 96, 8, 8], location [B, 3] -> [B, 6, 64], each of length 8.
  torch::Tensor tokenize(const torch::Tensor& z, const torch::Tensor& location);

  /// Latent embedding Z'. tokens [B, 6, 64] -> [B, 96, 8, 8].
  torch::Tensor detokenize(const torch::Tensor& tokens);

  /// z [B, 96, 8, 8] -> the object's picture.
  DecodedObject decode(const torch::Tensor& z);

  /// Where the object's crop lies. tokens [B, 6, 64] -> [B, 3], as `EncoderInput::location`.
  torch::Tensor locate(const torch::Tensor& tokens);

  /// Logits of each token for the prototypes of a concept. tokens [B, 6, 64] -> [B, values].
  torch::Tensor prototypeLogits(const torch::Tensor& tokens, Concept which) const;

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
  torch::nn::Sequential decoder_{nullptr};
  torch::nn::Sequential locator_{nullptr};
  std::vector<torch::Tensor> prototypes_;  // a concept: [values, 64]
};
TORCH_MODULE(ConceptNetwork);

}  // namespace conceptplan
