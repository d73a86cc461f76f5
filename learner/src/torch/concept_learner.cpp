#include "conceptplan/learner/concept_learner.hpp"

#include <algorithm>

#include "conceptplan/learner/torch/concept_network.hpp"
#include "conceptplan/learner/torch/encoder_batch.hpp"
#include "conceptplan/learner/torch/generator_guard.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/torch/token_tensors.hpp"

namespace conceptplan {
namespace {

ConceptNetwork freshNetwork(EncoderKind encoder) {
  const GeneratorGuard guard;
  return ConceptNetwork(encoder);
}

}  // namespace

struct ConceptLearner::Network {
  ConceptNetwork network;
};

ConceptLearner::ConceptLearner(const NamedTensors& tensors, EncoderKind encoder,
                               const std::filesystem::path& path)
    : network_(std::make_unique<Network>(Network{freshNetwork(encoder)})) {
  setTensors(*network_->network, tensors, "concepts.", path);
  network_->network->eval();
}

ConceptLearner::~ConceptLearner() = default;
ConceptLearner::ConceptLearner(ConceptLearner&&) noexcept = default;
ConceptLearner& ConceptLearner::operator=(ConceptLearner&&) noexcept = default;

std::vector<Tokens> ConceptLearner::encode(std::span<const EncoderInput> inputs) const {
  constexpr std::size_t kBatch = 64;
  const torch::InferenceMode inference;
  ConceptNetwork& network = network_->network;
  std::vector<Tokens> tokens;
  for (std::size_t begin = 0; begin < inputs.size(); begin += kBatch) {
    const EncoderBatch batch =
        encoderBatch(inputs.subspan(begin, std::min(kBatch, inputs.size() - begin)));
    const auto z =
        network->encode(encoderPlanes(batch.bytes, batch.location, network->encoderKind()));
    const auto part = toTokens(network->tokenize(z, batch.location));
    tokens.insert(tokens.end(), part.begin(), part.end());
  }
  return tokens;
}

std::vector<DrawnObject> ConceptLearner::draw(std::span<const Tokens> tokens) const {
  if (tokens.empty()) return {};
  const torch::InferenceMode inference;
  const auto input = toTensor(tokens);
  ConceptNetwork& network = network_->network;
  const DecodedObject decoded = network->draw(input);
  const auto location = network->locate(input).contiguous();
  auto planes = torch::cat({decoded.rgb, decoded.depth, torch::sigmoid(decoded.mask_logits)}, 1);
  if (network->encoderKind() == EncoderKind::kFullFrame) planes = cropsOf(planes, location);
  planes = planes.contiguous();
  constexpr std::size_t kPixels = EncoderInput::kPixels;
  std::vector<DrawnObject> drawn(tokens.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const float* rgb = planes.data_ptr<float>() + i * EncoderInput::kChannels * kPixels;
    const float* level = rgb + 3 * kPixels;
    const float* alpha = level + kPixels;
    std::copy_n(location.data_ptr<float>() + 3 * i, 3, drawn[i].location.begin());
    drawn[i].rgb.assign(rgb, level);
    drawn[i].alpha.assign(alpha, alpha + kPixels);
    for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
      drawn[i].depth_m.push_back(depthOf(drawn[i].location, 255.0F * level[pixel]));
  }
  return drawn;
}

}  // namespace conceptplan
