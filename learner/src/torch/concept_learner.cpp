#include "conceptplan/learner/concept_learner.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/torch/concept_network.hpp"
#include "conceptplan/learner/torch/encoder_batch.hpp"
#include "conceptplan/learner/torch/generator_guard.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/torch/token_tensors.hpp"

namespace conceptplan {
namespace {

/// Half frames, and half metres, from the middle: far outside of all pictures.
constexpr double kFarthestLocation = 100;
/// Objects that pass the network together.
constexpr std::size_t kBatch = 64;

ConceptNetwork freshNetwork(EncoderKind encoder) {
  const GeneratorGuard guard;
  return ConceptNetwork(encoder);
}

}  // namespace

struct ConceptLearner::Network {
  ConceptNetwork network;
  std::filesystem::path path;

  /// @throws InputError unless all numbers are finite.
  void check(const torch::Tensor& numbers, const char* what) const {
    if (!torch::isfinite(numbers).all().item<bool>())
      throw InputError({{path.string(),
                         {},
                         {},
                         "concepts",
                         std::string("the weights give ") + what + " that are not finite"}});
  }
};

ConceptLearner::ConceptLearner(const NamedTensors& tensors, EncoderKind encoder,
                               const std::filesystem::path& path)
    : network_(std::make_unique<Network>(Network{freshNetwork(encoder), path})) {
  setTensors(*network_->network, tensors, "concepts.", path);
  network_->network->eval();
}

ConceptLearner::~ConceptLearner() = default;
ConceptLearner::ConceptLearner(ConceptLearner&&) noexcept = default;
ConceptLearner& ConceptLearner::operator=(ConceptLearner&&) noexcept = default;

std::vector<Tokens> ConceptLearner::encode(std::span<const EncoderInput> inputs) const {
  for (const EncoderInput& input : inputs)
    for (const float number : input.location)
      if (!std::isfinite(number))
        throw std::invalid_argument("ConceptLearner::encode: an object lies at " +
                                    std::to_string(number));
  const torch::InferenceMode inference;
  ConceptNetwork& network = network_->network;
  std::vector<Tokens> tokens;
  for (std::size_t begin = 0; begin < inputs.size(); begin += kBatch) {
    const EncoderBatch batch =
        encoderBatch(inputs.subspan(begin, std::min(kBatch, inputs.size() - begin)));
    const auto z =
        network->encode(encoderPlanes(batch.bytes, batch.location, network->encoderKind()));
    const auto read = network->tokenize(z, batch.location);
    network_->check(read, "tokens");
    const auto part = toTokens(read);
    tokens.insert(tokens.end(), part.begin(), part.end());
  }
  return tokens;
}

std::vector<DrawnObject> ConceptLearner::draw(std::span<const Tokens> tokens) const {
  for (const Tokens& one : tokens)
    if (!one.allFinite())
      throw std::invalid_argument("ConceptLearner::draw: tokens are not finite");
  const torch::InferenceMode inference;
  ConceptNetwork& network = network_->network;
  constexpr std::size_t kPixels = EncoderInput::kPixels;
  std::vector<DrawnObject> drawn;
  for (std::size_t begin = 0; begin < tokens.size(); begin += kBatch) {
    const auto input = toTensor(tokens.subspan(begin, std::min(kBatch, tokens.size() - begin)));
    const DecodedObject decoded = network->draw(input);
    const auto located = network->locate(input);
    network_->check(located, "locations");
    const auto location = located.clamp(-kFarthestLocation, kFarthestLocation).contiguous();
    auto planes = torch::cat({decoded.rgb, decoded.depth, torch::sigmoid(decoded.mask_logits)}, 1);
    if (network->encoderKind() == EncoderKind::kFullFrame) planes = cropsOf(planes, location);
    network_->check(planes, "pictures");
    planes = planes.contiguous();
    for (std::int64_t i = 0; i < input.size(0); ++i) {
      const float* rgb = planes.data_ptr<float>() +
                         static_cast<std::size_t>(i) * EncoderInput::kChannels * kPixels;
      const float* level = rgb + 3 * kPixels;
      const float* alpha = level + kPixels;
      DrawnObject& object = drawn.emplace_back();
      std::copy_n(location.data_ptr<float>() + 3 * i, 3, object.location.begin());
      object.rgb.assign(rgb, level);
      object.alpha.assign(alpha, alpha + kPixels);
      for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
        object.depth_m.push_back(depthOf(object.location, 255.0F * level[pixel]));
    }
  }
  return drawn;
}

}  // namespace conceptplan
