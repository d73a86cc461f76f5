#include "conceptplan/learner/torch/concept_trainer.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "conceptplan/learner/torch/concept_losses.hpp"
#include "conceptplan/learner/torch/encoder_batch.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/torch/training_state.hpp"

namespace conceptplan {
namespace {

constexpr std::int64_t kGroupImages = 1 + static_cast<std::int64_t>(kNumConcepts);

constexpr AugmentationOptions kNoAugmentation{0, 0, 0, 0, 0, 0, 0};

/// One batch of anchor groups.
struct AnchorBatch {
  EncoderBatch images;    // G * 7
  torch::Tensor differs;  // [G, 6]: whether partner k differs in concept k
  torch::Tensor pairs;    // [P, 2]: group and concept of each partner that differs
};

AnchorBatch drawBatch(const ConceptImages& images, const AnchorSampler& sampler,
                      std::int64_t groups, const AugmentationOptions& augmentation,
                      std::mt19937_64& generator) {
  auto differs = torch::empty({groups, static_cast<std::int64_t>(kNumConcepts)}, torch::kBool);
  auto* differ = differs.data_ptr<bool>();
  std::vector<EncoderInput> inputs;
  for (std::int64_t g = 0; g < groups; ++g) {
    const AnchorGroup group = sampler.draw(generator);
    differ = std::copy(group.differs.begin(), group.differs.end(), differ);
    for (const std::size_t image : group.images) {
      const std::size_t occluder = generator() % images.size();
      inputs.push_back(augmented(images.planes(image), images.location(image),
                                 images.planes(occluder), augmentation, generator));
    }
  }
  return {encoderBatch(inputs), differs, differs.nonzero()};
}

/// The terms of Eq. (3) that the decoder learns from, on some pairs of a batch: the
/// anchor from its own tokens, the partner from the anchor's tokens with one substituted, Eq. (1),
/// and the direct branch from the anchor's latent embedding. @returns their weighted sum.
torch::Tensor drawingLoss(ConceptNetwork& network, const AnchorBatch& batch,
                          const torch::Tensor& planes, const torch::Tensor& z,
                          const torch::Tensor& tokens, const ConceptTrainingOptions& options,
                          std::mt19937_64& generator, ConceptLosses& losses) {
  if (batch.pairs.size(0) == 0) return torch::zeros({});
  std::vector<std::int64_t> order(static_cast<std::size_t>(batch.pairs.size(0)));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), generator);
  const auto drawn_pairs =
      batch.pairs.index({torch::tensor(order).slice(0, 0, options.reconstructed_pairs)});
  const auto first = drawn_pairs.select(1, 0) * kGroupImages;
  const auto second = first + drawn_pairs.select(1, 1) + 1;
  const auto one_hot =
      torch::one_hot(drawn_pairs.select(1, 1), static_cast<std::int64_t>(kNumConcepts))
          .to(torch::kBool)
          .unsqueeze(-1);
  const auto substituted = torch::where(one_hot, tokens.index({second}), tokens.index({first}));
  const auto both = torch::cat({tokens.index({first}), substituted});
  const auto targets = torch::cat({first, second});
  const auto truth = planes.index({targets});
  const auto reconstruction = 2 * reconstructionLoss(network->decode(network->detokenize(both)),
                                                     truth, options.foreground_weight);
  const auto direct =
      reconstructionLoss(network->decode(z.index({first})), truth.slice(0, 0, first.size(0)),
                         options.foreground_weight);
  const auto location =
      torch::smooth_l1_loss(network->locate(both), batch.images.location.index({targets}), 1, 0.05);
  losses.reconstruction = reconstruction.item<double>();
  losses.direct = direct.item<double>();
  losses.location = location.item<double>();
  return options.reconstruction_weight * (reconstruction + direct) + location;
}

/// A fresh network whose weights depend on the seed alone.
ConceptNetwork seededNetwork(EncoderKind encoder, std::uint64_t seed) {
  torch::manual_seed(seed);
  return ConceptNetwork(encoder);
}

/// Concept tokenizer and detokenizer first, all else second.
std::vector<torch::optim::OptimizerParamGroup> parameterGroups(const ConceptNetworkImpl& network) {
  std::vector<torch::Tensor> tokenizers, others;
  for (const auto& parameter : network.named_parameters()) {
    const std::string& name = parameter.key();
    const bool of_tokenizer = name.find("token") != std::string::npos ||
                              name.find("queries") != std::string::npos || name == "positions" ||
                              name.starts_with("to_latent");
    (of_tokenizer ? tokenizers : others).push_back(parameter.value());
  }
  return {torch::optim::OptimizerParamGroup(tokenizers), torch::optim::OptimizerParamGroup(others)};
}

}  // namespace

ConceptTrainer::ConceptTrainer(const ConceptImages& images, const ConceptTrainingOptions& options)
    : images_(images),
      options_(options),
      sampler_(images),
      network_(seededNetwork(options.encoder, options.seed)),
      average_(options.encoder),
      optimizer_(parameterGroups(*network_),
                 torch::optim::AdamWOptions(options.learning_rate).weight_decay(1e-4)) {
  copyParameters(*average_, *network_);
}

void ConceptTrainer::startFrom(const NamedTensors& tensors, const std::filesystem::path& path) {
  setTensors(*network_, tensors, "concepts.", path);
  copyParameters(*average_, *network_);
}

ConceptLosses ConceptTrainer::step() {
  auto generator = stepGenerator(options_.seed, steps_done_);
  const auto progress = [this](std::int64_t begin, std::int64_t steps) {
    return static_cast<double>(steps_done_ - begin) / static_cast<double>(steps);
  };
  const std::int64_t sharpening_from = options_.encoder_steps;
  const std::int64_t decoder_from = sharpening_from + options_.sharpening_steps;
  // The third phase draws from the tokens of the network that is kept.
  if (steps_done_ == decoder_from) copyParameters(*network_, *average_);
  const ConceptLosses losses =
      steps_done_ < sharpening_from ? tokenStep(generator, progress(0, sharpening_from), false)
      : steps_done_ < decoder_from
          ? tokenStep(generator, progress(sharpening_from, options_.sharpening_steps), true)
          : decoderStep(generator, progress(decoder_from, options_.decoder_steps));
  ++steps_done_;
  updateAverage(*average_, *network_, options_.averaging, steps_done_);
  return losses;
}

ConceptLosses ConceptTrainer::tokenStep(std::mt19937_64& generator, double progress,
                                        bool sharpening) {
  const AnchorBatch batch =
      drawBatch(images_, sampler_, options_.groups, options_.augmentation, generator);
  const auto planes = encoderPlanes(batch.images.bytes, batch.images.location, options_.encoder);
  const auto z = network_->encode(planes);
  const auto tokens = network_->tokenize(z, batch.images.location);
  const auto groups = tokens.view({options_.groups, kGroupImages, kNumConcepts, kTokenWidth});

  ConceptLosses losses;
  // Eq. (2) on each anchor and its partners that differ from it.
  const auto group = batch.pairs.select(1, 0), differing = batch.pairs.select(1, 1);
  const auto disentangling = conceptDisentanglingLoss(
      groups.index({group, 0}), groups.index({group, differing + 1}), differing.contiguous());
  auto pair = torch::zeros({});
  auto use = torch::zeros({});
  auto confidence = torch::zeros({});
  for (const Concept which : kConcepts) {
    const auto values = torch::softmax(network_->prototypeLogits(tokens, which), -1);
    const auto k = static_cast<std::int64_t>(index(which));
    pair = pair + pairLikelihoodLoss(values.view({options_.groups, kGroupImages, -1}),
                                     batch.differs.select(1, k), 1 + k);
    use = use + prototypeUseLoss(values);
    confidence = confidence + prototypeEntropy(values);
  }
  losses.disentangling = disentangling.item<double>();
  losses.pair = pair.item<double>();
  losses.use = use.item<double>();
  losses.confidence = confidence.item<double>();
  auto total = options_.disentangling_weight * disentangling + options_.pair_weight * pair +
               options_.use_weight * use;
  if (sharpening) total = total + options_.confidence_weight * confidence;
  if (!sharpening && progress >= options_.reconstruction_start)
    total = total + drawingLoss(network_, batch, planes, z, tokens, options_, generator, losses);
  descend(total, progress);
  return losses;
}

ConceptLosses ConceptTrainer::decoderStep(std::mt19937_64& generator, double progress) {
  const AnchorBatch batch =
      drawBatch(images_, sampler_, options_.decoder_groups, kNoAugmentation, generator);
  const auto planes = encoderPlanes(batch.images.bytes, batch.images.location, options_.encoder);
  torch::Tensor z, tokens;
  {
    const torch::NoGradGuard fixed;
    z = network_->encode(planes);
    tokens = network_->tokenize(z, batch.images.location);
  }
  ConceptLosses losses;
  const auto total = drawingLoss(network_, batch, planes, z, tokens, options_, generator, losses);
  descend(total, progress);
  return losses;
}

void ConceptTrainer::descend(const torch::Tensor& loss, double progress) {
  // Without a gradient the optimizer leaves a parameter alone; with one of zero it would decay it.
  for (auto& parameter : network_->parameters()) parameter.mutable_grad() = torch::Tensor();
  if (!loss.requires_grad()) return;
  const double share = learningRateShare(progress, options_.warm_up);
  const auto setRate = [&](std::size_t group, double rate) {
    static_cast<torch::optim::AdamWOptions&>(optimizer_.param_groups()[group].options())
        .lr(rate * share);
  };
  setRate(0, options_.learning_rate * options_.tokenizer_rate_share);
  setRate(1, options_.learning_rate);
  loss.backward();
  torch::nn::utils::clip_grad_norm_(network_->parameters(), 5.0);
  optimizer_.step();
}

ConceptNetwork ConceptTrainer::averaged() const {
  ConceptNetwork copy(options_.encoder);
  copyParameters(*copy, *average_);
  copy->eval();
  return copy;
}

std::string ConceptTrainer::checkpoint() const {
  torch::serialize::OutputArchive archive, network, average, optimizer;
  network_->save(network);
  average_->save(average);
  optimizer_.save(optimizer);
  archive.write("network", network);
  archive.write("average", average);
  archive.write("optimizer", optimizer);
  archive.write("steps_done", torch::tensor(steps_done_));
  std::ostringstream bytes;
  archive.save_to(bytes);
  return bytes.str();
}

void ConceptTrainer::restore(const std::string& checkpoint) {
  torch::serialize::InputArchive archive, network, average, optimizer;
  std::istringstream bytes(checkpoint);
  archive.load_from(bytes);
  archive.read("network", network);
  archive.read("average", average);
  archive.read("optimizer", optimizer);
  torch::Tensor steps_done;
  archive.read("steps_done", steps_done);
  network_->load(network);
  average_->load(average);
  optimizer_.load(optimizer);
  steps_done_ = steps_done.item<std::int64_t>();
}

}  // namespace conceptplan
