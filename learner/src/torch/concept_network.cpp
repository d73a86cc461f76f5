#include "conceptplan/learner/torch/concept_network.hpp"

#include <cmath>
#include <string>

namespace conceptplan {
namespace {

namespace nn = torch::nn;
namespace functional = torch::nn::functional;

constexpr std::int64_t kLatentChannels = 96;
constexpr std::int64_t kLatentEdge = 8;
constexpr std::int64_t kCells = kLatentEdge * kLatentEdge;
constexpr std::int64_t kConceptCount = static_cast<std::int64_t>(kNumConcepts);
constexpr std::int64_t kHeads = 4;
constexpr double kPrototypeScale = 12.0;

nn::Conv2d convolution(std::int64_t in, std::int64_t out, std::int64_t kernel,
                       std::int64_t stride) {
  return nn::Conv2d(nn::Conv2dOptions(in, out, kernel).stride(stride).padding((kernel - 1) / 2));
}

nn::GroupNorm normalization(std::int64_t channels) {
  return nn::GroupNorm(nn::GroupNormOptions(8, channels));
}

/// x + conv(relu(norm(conv(relu(norm(x)))))). [B, C, H, W] -> [B, C, H, W].
class ResidualBlockImpl : public nn::Module {
 public:
  explicit ResidualBlockImpl(std::int64_t channels)
      : body_(register_module(
            "body", nn::Sequential(normalization(channels), nn::ReLU(),
                                   convolution(channels, channels, 3, 1), normalization(channels),
                                   nn::ReLU(), convolution(channels, channels, 3, 1)))) {}

  torch::Tensor forward(const torch::Tensor& x) { return x + body_->forward(x); }

 private:
  nn::Sequential body_;
};
TORCH_MODULE(ResidualBlock);

/// Convolution and pixel shuffle. [B, in, H, W] -> [B, out, 2H, 2W].
class UpsamplingImpl : public nn::Module {
 public:
  UpsamplingImpl(std::int64_t in, std::int64_t out)
      : convolution_(register_module("convolution", convolution(in, 4 * out, 3, 1))) {}

  torch::Tensor forward(const torch::Tensor& x) { return torch::pixel_shuffle(convolution_(x), 2); }

 private:
  nn::Conv2d convolution_;
};
TORCH_MODULE(Upsampling);

/// Concept queries cross-attend to image tokens, then each passes a perceptron; concept tokens
/// never attend to each other. Source: Visual Concepts Tokenization, arXiv 2205.10093.
class CrossAttentionLayerImpl : public nn::Module {
 public:
  CrossAttentionLayerImpl()
      : query_norm_(register_module("query_norm", layerNorm())),
        image_norm_(register_module("image_norm", layerNorm())),
        query_(register_module("query", nn::Linear(kTokenWidth, kTokenWidth))),
        key_(register_module("key", nn::Linear(kTokenWidth, kTokenWidth))),
        value_(register_module("value", nn::Linear(kTokenWidth, kTokenWidth))),
        out_(register_module("out", nn::Linear(kTokenWidth, kTokenWidth))),
        perceptron_(register_module(
            "perceptron", nn::Sequential(layerNorm(), nn::Linear(kTokenWidth, 2 * kTokenWidth),
                                         nn::GELU(), nn::Linear(2 * kTokenWidth, kTokenWidth)))) {}

  /// concepts [B, 6, 64], image [B, N, 64] -> [B, 6, 64].
  torch::Tensor forward(const torch::Tensor& concepts, const torch::Tensor& image) {
    const auto keys_from = image_norm_(image);
    const auto q = heads(query_(query_norm_(concepts)));
    const auto k = heads(key_(keys_from));
    const auto v = heads(value_(keys_from));
    const double scale = 1.0 / std::sqrt(static_cast<double>(kTokenWidth / kHeads));
    const auto attention = torch::softmax(torch::matmul(q, k.transpose(-2, -1)) * scale, -1);
    const auto mixed = torch::matmul(attention, v).transpose(1, 2).reshape(concepts.sizes());
    const auto attended = concepts + out_(mixed);
    return attended + perceptron_->forward(attended);
  }

 private:
  static nn::LayerNorm layerNorm() { return nn::LayerNorm(nn::LayerNormOptions({kTokenWidth})); }

  static torch::Tensor heads(const torch::Tensor& x) {
    return x.view({x.size(0), x.size(1), kHeads, kTokenWidth / kHeads}).transpose(1, 2);
  }

  nn::LayerNorm query_norm_, image_norm_;
  nn::Linear query_, key_, value_, out_;
  nn::Sequential perceptron_;
};
TORCH_MODULE(CrossAttentionLayer);

/// 64 x 64 crop, 5 channels -> 8 x 8.
nn::Sequential objectCentredEncoder() {
  return nn::Sequential(nn::Conv2d(nn::Conv2dOptions(5, 32, 4).stride(2).padding(1)), nn::ReLU(),
                        convolution(32, 64, 3, 2), normalization(64), nn::ReLU(),
                        convolution(64, kLatentChannels, 3, 2), ResidualBlock(kLatentChannels),
                        ResidualBlock(kLatentChannels));
}

/// 256 x 256 frame, 4 channels -> 8 x 8: 3 convolutions and 2 residual blocks, then 4 and 2, as
/// the authors describe it.
nn::Sequential fullFrameEncoder() {
  return nn::Sequential(convolution(4, 16, 3, 2), nn::ReLU(), convolution(16, 32, 3, 2), nn::ReLU(),
                        convolution(32, 64, 3, 2), ResidualBlock(64), ResidualBlock(64),
                        convolution(64, 64, 3, 2), nn::ReLU(), convolution(64, 96, 3, 2),
                        nn::ReLU(), convolution(96, 96, 3, 1), nn::ReLU(),
                        convolution(96, kLatentChannels, 3, 1), ResidualBlock(kLatentChannels),
                        ResidualBlock(kLatentChannels));
}

}  // namespace

ConceptNetworkImpl::ConceptNetworkImpl(EncoderKind encoder) : encoder_kind_(encoder) {
  encoder_ =
      register_module("encoder", encoder == EncoderKind::kObjectCentred ? objectCentredEncoder()
                                                                        : fullFrameEncoder());
  location_embedding_ = register_module(
      "location_embedding", nn::Sequential(nn::Linear(3, 64), nn::GELU(), nn::Linear(64, 64),
                                           nn::GELU(), nn::Linear(64, kTokenWidth)));
  concept_queries_ =
      register_parameter("concept_queries", torch::randn({kConceptCount, kTokenWidth}));
  positions_ = register_parameter("positions", 0.5 * torch::randn({kCells, kTokenWidth}));
  image_tokens_ = register_module("image_tokens", nn::Linear(kLatentChannels, kTokenWidth));
  tokenizer_layers_ = register_module("tokenizer_layers", nn::ModuleList());
  for (int layer = 0; layer < 3; ++layer) tokenizer_layers_->push_back(CrossAttentionLayer());
  to_tokens_ = register_module("to_tokens", nn::Linear(kTokenWidth, kTokenWidth));
  detokenizer_ = register_module(
      "detokenizer", nn::Sequential(nn::Linear(kConceptCount * kTokenWidth, 512), nn::GELU(),
                                    nn::Linear(512, 512), nn::GELU(), nn::Linear(512, 64 * 16)));
  detokenizer_upsampling_ = register_module(
      "detokenizer_upsampling",
      nn::Sequential(nn::ReLU(), Upsampling(64, kLatentChannels), ResidualBlock(kLatentChannels)));
  decoder_ = register_module(
      "decoder",
      nn::Sequential(ResidualBlock(kLatentChannels), nn::ReLU(), Upsampling(kLatentChannels, 48),
                     normalization(48), nn::ReLU(), Upsampling(48, 24), normalization(24),
                     nn::ReLU(), Upsampling(24, 16), nn::ReLU(), convolution(16, 5, 3, 1)));
  locator_ = register_module("locator", nn::Sequential(nn::Linear(kConceptCount * kTokenWidth, 128),
                                                       nn::GELU(), nn::Linear(128, 3)));
  for (const Concept which : kConcepts)
    prototypes_.push_back(register_parameter(
        "prototypes_" + std::string(conceptplan::name(which)),
        torch::randn({static_cast<std::int64_t>(kConceptCardinality[index(which)]), kTokenWidth})));
}

torch::Tensor ConceptNetworkImpl::encode(const torch::Tensor& planes) {
  return encoder_->forward(planes.contiguous(torch::MemoryFormat::ChannelsLast));
}

torch::Tensor ConceptNetworkImpl::tokenize(const torch::Tensor& z, const torch::Tensor& location) {
  const auto cells = z.flatten(2).transpose(1, 2);  // [B, 64, 96]
  const auto image = image_tokens_(cells) + positions_;
  const auto where = location_embedding_->forward(location).unsqueeze(1);
  const auto context = torch::cat({image, where}, 1);  // [B, 65, 64]
  auto tokens = concept_queries_.unsqueeze(0).expand({z.size(0), kConceptCount, kTokenWidth});
  for (const auto& layer : *tokenizer_layers_)
    tokens = layer->as<CrossAttentionLayer>()->forward(tokens, context);
  return torch::layer_norm(to_tokens_(tokens), {kTokenWidth});
}

torch::Tensor ConceptNetworkImpl::detokenize(const torch::Tensor& tokens) {
  const auto coarse = detokenizer_->forward(tokens.flatten(1)).view({tokens.size(0), 64, 4, 4});
  return detokenizer_upsampling_->forward(coarse.contiguous(torch::MemoryFormat::ChannelsLast));
}

DecodedObject ConceptNetworkImpl::decode(const torch::Tensor& z) {
  const auto drawn = decoder_->forward(z);
  return {torch::sigmoid(drawn.slice(1, 0, 3)), drawn.slice(1, 3, 4),
          torch::sigmoid(drawn.slice(1, 4, 5))};
}

torch::Tensor ConceptNetworkImpl::locate(const torch::Tensor& tokens) {
  return locator_->forward(tokens.flatten(1));
}

torch::Tensor ConceptNetworkImpl::prototypeLogits(const torch::Tensor& tokens,
                                                  Concept which) const {
  const auto of_concept = tokens.select(1, static_cast<std::int64_t>(index(which)));
  return kPrototypeScale *
         torch::matmul(functional::normalize(of_concept, functional::NormalizeFuncOptions().dim(1)),
                       functional::normalize(prototypes_[index(which)],
                                             functional::NormalizeFuncOptions().dim(1))
                           .t());
}

}  // namespace conceptplan
