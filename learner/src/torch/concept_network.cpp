#include "conceptplan/learner/torch/concept_network.hpp"

#include <string>

#include "network_blocks.hpp"

namespace conceptplan {
namespace {

using namespace network;
namespace functional = torch::nn::functional;

constexpr std::int64_t kLatentEdge = 8;
constexpr std::int64_t kCells = kLatentEdge * kLatentEdge;
constexpr std::int64_t kConceptCount = static_cast<std::int64_t>(kNumConcepts);
constexpr double kPrototypeScale = 12.0;

std::int64_t latentChannels(EncoderKind encoder) {
  return encoder == EncoderKind::kObjectCentred ? 96 : 64;
}

/// 64 x 64 crop, 5 channels -> 8 x 8.
nn::Sequential objectCentredEncoder(std::int64_t channels) {
  return nn::Sequential(nn::Conv2d(nn::Conv2dOptions(5, 32, 4).stride(2).padding(1)), nn::ReLU(),
                        convolution(32, 64, 3, 2), normalization(64), nn::ReLU(),
                        convolution(64, channels, 3, 2), ResidualBlock(channels),
                        ResidualBlock(channels));
}

/// 8 x 8 -> 64 x 64.
nn::Sequential objectCentredDecoder(std::int64_t channels) {
  return nn::Sequential(ResidualBlock(channels), nn::ReLU(), Upsampling(channels, 48),
                        normalization(48), nn::ReLU(), Upsampling(48, 24), normalization(24),
                        nn::ReLU(), Upsampling(24, 16), nn::ReLU(),
                        convolution(16, kDrawnChannels, 3, 1));
}

/// 256 x 256 frame, 4 channels -> 8 x 8: 3 convolutions and 2 residual blocks, then 4 and 2, as
/// the authors describe it.
nn::Sequential fullFrameEncoder(std::int64_t channels) {
  return nn::Sequential(
      convolution(4, 16, 3, 2), nn::ReLU(), convolution(16, 32, 3, 2), nn::ReLU(),
      convolution(32, 64, 3, 2), ResidualBlock(64), ResidualBlock(64), convolution(64, 64, 3, 2),
      nn::ReLU(), convolution(64, 64, 3, 2), nn::ReLU(), convolution(64, 64, 3, 1), nn::ReLU(),
      convolution(64, channels, 3, 1), ResidualBlock(channels), ResidualBlock(channels));
}

/// 8 x 8 -> 256 x 256: the encoder's mirror image.
nn::Sequential fullFrameDecoder(std::int64_t channels) {
  return nn::Sequential(
      transposedConvolution(channels, 64, 1), nn::ReLU(), transposedConvolution(64, 64, 1),
      nn::ReLU(), transposedConvolution(64, 64, 2), nn::ReLU(), transposedConvolution(64, 64, 2),
      ResidualBlock(64), ResidualBlock(64), transposedConvolution(64, 32, 2), nn::ReLU(),
      transposedConvolution(32, 16, 2), nn::ReLU(), transposedConvolution(16, 16, 2),
      ResidualBlock(16), ResidualBlock(16), nn::ReLU(), convolution(16, kDrawnChannels, 3, 1));
}

nn::ModuleList crossAttention() {
  nn::ModuleList layers;
  for (int layer = 0; layer < 3; ++layer) layers->push_back(CrossAttentionLayer());
  return layers;
}

torch::Tensor attend(const nn::ModuleList& layers, torch::Tensor queries,
                     const torch::Tensor& context) {
  for (const auto& layer : *layers)
    queries = layer->as<CrossAttentionLayer>()->forward(queries, context);
  return queries;
}

/// [N, 64] -> [B, N, 64].
torch::Tensor forEach(std::int64_t batch, const torch::Tensor& queries) {
  return queries.unsqueeze(0).expand({batch, queries.size(0), queries.size(1)});
}

}  // namespace

ConceptNetworkImpl::ConceptNetworkImpl(EncoderKind encoder) : encoder_kind_(encoder) {
  const bool centred = encoder == EncoderKind::kObjectCentred;
  const std::int64_t channels = latentChannels(encoder);
  encoder_ = register_module("encoder",
                             centred ? objectCentredEncoder(channels) : fullFrameEncoder(channels));
  if (centred)
    location_embedding_ = register_module(
        "location_embedding", nn::Sequential(nn::Linear(3, 64), nn::GELU(), nn::Linear(64, 64),
                                             nn::GELU(), nn::Linear(64, kTokenWidth)));
  concept_queries_ =
      register_parameter("concept_queries", torch::randn({kConceptCount, kTokenWidth}));
  positions_ = register_parameter("positions", 0.5 * torch::randn({kCells, kTokenWidth}));
  image_tokens_ = register_module("image_tokens", nn::Linear(channels, kTokenWidth));
  tokenizer_layers_ = register_module("tokenizer_layers", crossAttention());
  to_tokens_ = register_module("to_tokens", nn::Linear(kTokenWidth, kTokenWidth));
  if (centred) {
    detokenizer_ = register_module(
        "detokenizer", nn::Sequential(nn::Linear(kConceptCount * kTokenWidth, 512), nn::GELU(),
                                      nn::Linear(512, 512), nn::GELU(), nn::Linear(512, 64 * 16)));
    detokenizer_upsampling_ = register_module(
        "detokenizer_upsampling",
        nn::Sequential(nn::ReLU(), Upsampling(64, channels), ResidualBlock(channels)));
  } else {
    image_queries_ = register_parameter("image_queries", torch::randn({kCells, kTokenWidth}));
    detokenizer_layers_ = register_module("detokenizer_layers", crossAttention());
    to_latent_ = register_module("to_latent", nn::Linear(kTokenWidth, channels));
  }
  decoder_ = register_module("decoder",
                             centred ? objectCentredDecoder(channels) : fullFrameDecoder(channels));
  locator_ = register_module("locator", nn::Sequential(nn::Linear(kConceptCount * kTokenWidth, 128),
                                                       nn::GELU(), nn::Linear(128, 3)));
  for (const Concept which : kConcepts)
    prototypes_.push_back(register_parameter(
        "prototypes_" + std::string(conceptplan::name(which)),
        torch::randn({static_cast<std::int64_t>(kConceptCardinality[index(which)]), kTokenWidth})));
  if (centred) drawer_ = register_module("drawer", ObjectDrawer());
}

torch::Tensor ConceptNetworkImpl::encode(const torch::Tensor& planes) {
  const bool centred = encoder_kind_ == EncoderKind::kObjectCentred;
  return encoder_->forward(
      (centred ? planes : planes.slice(1, 0, 4)).contiguous(torch::MemoryFormat::ChannelsLast));
}

torch::Tensor ConceptNetworkImpl::tokenize(const torch::Tensor& z, const torch::Tensor& location) {
  const auto cells = z.flatten(2).transpose(1, 2);  // [B, 64, channels]
  auto context = image_tokens_(cells) + positions_;
  if (encoder_kind_ == EncoderKind::kObjectCentred)
    context = torch::cat({context, location_embedding_->forward(location).unsqueeze(1)}, 1);
  const auto tokens = attend(tokenizer_layers_, forEach(z.size(0), concept_queries_), context);
  return torch::layer_norm(to_tokens_(tokens), {kTokenWidth});
}

torch::Tensor ConceptNetworkImpl::detokenize(const torch::Tensor& tokens) {
  if (encoder_kind_ == EncoderKind::kFullFrame) {
    const auto cells = attend(detokenizer_layers_, forEach(tokens.size(0), image_queries_), tokens);
    return to_latent_(cells)
        .transpose(1, 2)
        .reshape({tokens.size(0), -1, kLatentEdge, kLatentEdge})
        .contiguous(torch::MemoryFormat::ChannelsLast);
  }
  const auto coarse = detokenizer_->forward(tokens.flatten(1)).view({tokens.size(0), 64, 4, 4});
  return detokenizer_upsampling_->forward(coarse.contiguous(torch::MemoryFormat::ChannelsLast));
}

DecodedObject ConceptNetworkImpl::decode(const torch::Tensor& z) {
  return decodedObject(decoder_->forward(z));
}

DecodedObject ConceptNetworkImpl::draw(const torch::Tensor& tokens) {
  if (drawer_.is_empty()) return decode(detokenize(tokens));
  return drawer_->forward(tokens, drawer_->locateInCrop(tokens));
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
