#include "conceptplan/learner/torch/concept_trainer.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/learner/torch/concept_losses.hpp"
#include "conceptplan/learner/torch/concept_pairs.hpp"
#include "conceptplan/learner/torch/encoder_batch.hpp"
#include "conceptplan/learner/torch/generator_guard.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/torch/training_state.hpp"

namespace conceptplan {
namespace {

constexpr std::int64_t kChainImages = 1 + static_cast<std::int64_t>(kNumConcepts);

/// A prototype with less than this share of an even use is dead.
constexpr double kDeadShare = 0.2;
/// Batches that are read to see which prototypes are dead.
constexpr std::int64_t kUseBatches = 4;
/// Batches that are read to see whether pairs are told.
constexpr std::int64_t kPairBatches = 16;
/// With more than this share of either kind of pairs told wrongly, values share prototypes. Of
/// eight values two that share one are 1 of 28 pairs that differ.
constexpr double kMostWrongPairs = 0.01;

/// One batch of chains.
struct ChainBatch {
  EncoderBatch images;                 // G * 7
  ConceptPairs pairs;                  // the paper's
  std::vector<torch::Tensor> changed;  // of each concept, [G, 7]: whether it has changed
};

ChainBatch drawBatch(const ConceptImages& images, const ChainSampler& sampler, std::int64_t chains,
                     const AugmentationOptions& augmentation, std::mt19937_64& generator) {
  std::vector<EncoderInput> inputs;
  std::vector<ConceptChain> drawn;
  auto changed =
      torch::zeros({static_cast<std::int64_t>(kNumConcepts), chains, kChainImages}, torch::kBool);
  for (std::int64_t c = 0; c < chains; ++c) {
    const ConceptChain& chain = drawn.emplace_back(sampler.draw(generator));
    for (const std::size_t image : chain.images) {
      const std::size_t occluder = generator() % images.size();
      inputs.push_back(augmented(images.planes(image), images.location(image),
                                 images.planes(occluder), augmentation, generator));
    }
    for (std::size_t link = 0; link < kNumConcepts; ++link) {
      if (!chain.differs[link]) continue;
      const auto which = static_cast<std::int64_t>(chain.concepts[link]);
      changed[which][c].slice(0, static_cast<std::int64_t>(1 + link)).fill_(true);
    }
  }
  return {encoderBatch(inputs), pairsOf(drawn), changed.unbind()};
}

ReadImages readBatch(ConceptNetwork& network, const EncoderBatch& images) {
  const auto planes = encoderPlanes(images.bytes, images.location, network->encoderKind());
  const auto z = network->encode(planes);
  return {planes, images.location, z, network->tokenize(z, images.location)};
}

/// Mean squared error of the tokens that drawn objects are read as, against those they were drawn
/// from. tokens [B, 6, 64], location [B, 3].
torch::Tensor readingLoss(ConceptNetwork& network, const DecodedObject& drawn,
                          const torch::Tensor& location, const torch::Tensor& tokens) {
  // The mask is cut as in a drawn frame; its gradient is that of the uncut one.
  const auto soft = torch::sigmoid(drawn.mask_logits);
  const auto mask = soft + ((soft > 0.5).to(torch::kFloat) - soft).detach();
  const auto planes = torch::cat({drawn.rgb * mask, drawn.depth * mask, mask}, 1);
  return torch::mse_loss(network->tokenize(network->encode(planes), location), tokens);
}

/// Whether a parameter serves to show objects.
bool draws(const std::string& name) {
  return name.starts_with("drawer") || name.starts_with("locator");
}

/// Smooth absolute error of where the crops lie, as their tokens tell.
torch::Tensor locationLoss(ConceptNetwork& network, const PairsToDraw& pairs) {
  return torch::smooth_l1_loss(network->locate(pairs.tokens), pairs.location, 1, 0.05);
}

ConceptLosses lossesOf(const ConceptTerms& terms) {
  ConceptLosses losses;
  losses.disentangling = terms.disentangling.item<double>();
  losses.pair = terms.pair.item<double>();
  losses.use = terms.use.item<double>();
  losses.confidence = terms.confidence.item<double>();
  losses.reconstruction = terms.reconstruction.item<double>();
  losses.direct = terms.direct.item<double>();
  losses.location = terms.location.item<double>();
  return losses;
}

/// Which run a checkpoint is of: every option and a checksum of the images.
CheckpointIdentity identityOf(const ConceptImages& images, const ConceptTrainingOptions& options) {
  CheckpointIdentity identity;
  identity.add("stage", std::string("concepts"));
  identity.add("seed", options.seed);
  identity.add("images", hexadecimal(images.checksum()));
  identity.add("start_from", options.start_from);
  identity.add("encoder", std::string(name(options.encoder)));
  identity.add("encoder_steps", options.encoder_steps);
  identity.add("repair_steps", options.repair_steps);
  identity.add("most_repairs", options.most_repairs);
  identity.add("sharpening_steps", options.sharpening_steps);
  identity.add("drawer_steps", options.drawer_steps);
  identity.add("chains", options.chains);
  identity.add("drawer_chains", options.drawer_chains);
  identity.add("learning_rate", options.learning_rate);
  identity.add("tokenizer_rate_share", options.tokenizer_rate_share);
  identity.add("warm_up", options.warm_up);
  identity.add("reconstruction_start", options.reconstruction_start);
  identity.add("reconstructed_pairs", options.reconstructed_pairs);
  identity.add("foreground_weight", options.foreground_weight);
  identity.add("disentangling_weight", options.disentangling_weight);
  identity.add("pair_weight", options.pair_weight);
  identity.add("use_weight", options.use_weight);
  identity.add("confidence_weight", options.confidence_weight);
  identity.add("reconstruction_weight", options.reconstruction_weight);
  identity.add("revival_interval", options.revival_interval);
  identity.add("sharpness_weight", options.sharpness_weight);
  identity.add("reading_weight", options.reading_weight);
  identity.add("drawer_rate_share", options.drawer_rate_share);
  identity.add("settling", options.settling);
  identity.add("averaging", options.averaging);
  const AugmentationOptions& varied = options.augmentation;
  identity.add("augmentation.occlusion", varied.occlusion);
  identity.add("augmentation.mask_noise", varied.mask_noise);
  identity.add("augmentation.shadow", varied.shadow);
  identity.add("augmentation.gain", varied.gain);
  identity.add("augmentation.channel_gain", varied.channel_gain);
  identity.add("augmentation.noise", varied.noise);
  identity.add("augmentation.shift_px", std::int64_t{varied.shift_px});
  return identity;
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
    : ConceptTrainer(images, options, GeneratorGuard(options.seed)) {}

ConceptTrainer::ConceptTrainer(const ConceptImages& images, const ConceptTrainingOptions& options,
                               const GeneratorGuard&)
    : images_(images),
      options_(options),
      identity_(identityOf(images, options)),
      sampler_(images),
      network_(options.encoder),
      average_(options.encoder),
      optimizer_(parameterGroups(*network_),
                 torch::optim::AdamWOptions(options.learning_rate).weight_decay(1e-4)) {
  if (options.drawer_steps > 0 && options.encoder == EncoderKind::kFullFrame)
    throw std::invalid_argument("ConceptTrainer: whole frames have no drawer to take " +
                                std::to_string(options.drawer_steps) + " steps");
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
  const std::int64_t sharpening_from = tokenSteps() - options_.sharpening_steps;
  const std::int64_t drawer_from = tokenSteps();
  const std::int64_t course_steps = repairs_ > 0 ? options_.repair_steps : options_.encoder_steps;
  const std::int64_t settled_from = drawer_from - options_.revival_interval;
  if (options_.pair_weight > 0 && steps_done_ > 0 && steps_done_ < settled_from &&
      steps_done_ % options_.revival_interval == 0)
    revivePrototypes(generator);
  // The third phase draws from the tokens of the network that is kept.
  if (steps_done_ == drawer_from) copyParameters(*network_, *average_);
  const ConceptLosses losses =
      steps_done_ < sharpening_from
          ? tokenStep(generator, progress(sharpening_from - course_steps, course_steps), false)
      : steps_done_ < drawer_from
          ? tokenStep(generator, progress(sharpening_from, options_.sharpening_steps), true)
          : drawerStep(generator, progress(drawer_from, options_.drawer_steps));
  ++steps_done_;
  updateAverage(*average_, *network_, options_.averaging, steps_done_);
  if (options_.encoder_steps > 0 && steps_done_ == tokenSteps() &&
      repairs_ < options_.most_repairs && prototypesShareValues(generator)) {
    ++repairs_;
    optimizer_.state().clear();
  }
  return losses;
}

ConceptLosses ConceptTrainer::tokenStep(std::mt19937_64& generator, double progress,
                                        bool sharpening) {
  const ChainBatch batch =
      drawBatch(images_, sampler_, options_.chains, options_.augmentation, generator);
  const ReadImages read = readBatch(network_, batch.images);
  const torch::Tensor& tokens = read.tokens;

  ConceptTerms terms;
  terms.disentangling = conceptDisentanglingLoss(
      tokens.index({batch.pairs.first}), tokens.index({batch.pairs.second}), batch.pairs.differing);
  for (const Concept which : kConcepts) {
    const auto log_values = torch::log_softmax(network_->prototypeLogits(tokens, which), -1);
    const auto values = log_values.exp();
    terms.pair =
        terms.pair + pairLikelihoodLoss(log_values.view({options_.chains, kChainImages, -1}),
                                        batch.changed[index(which)]);
    terms.use = terms.use + prototypeUseLoss(values);
    terms.confidence = terms.confidence + prototypeEntropy(values);
  }
  const bool drawing = !sharpening && progress >= options_.reconstruction_start;
  if (drawing && batch.pairs.first.size(0) > 0) {
    const PairsToDraw pairs =
        choosePairs(batch.pairs, read, options_.reconstructed_pairs, generator);
    const DecodedObject drawn = network_->decode(network_->detokenize(pairs.tokens));
    terms.direct = reconstructionLoss(network_->decode(read.z.index({pairs.first})),
                                      pairs.truth.slice(0, 0, pairs.first.size(0)),
                                      options_.foreground_weight);
    terms.reconstruction = pairReconstructionLoss(drawn, pairs.truth, options_.foreground_weight);
    terms.location = locationLoss(network_, pairs);
  }
  descend(conceptLoss(terms, options_, sharpening), progress, 1);
  return lossesOf(terms);
}

void ConceptTrainer::revivePrototypes(std::mt19937_64& generator) {
  const torch::NoGradGuard no_gradient;
  const ChainBatch batch =
      drawBatch(images_, sampler_, kUseBatches * options_.chains, options_.augmentation, generator);
  const torch::Tensor tokens = readBatch(network_, batch.images).tokens;
  const GeneratorGuard guard(generator());
  for (const Concept which : kConcepts) {
    const auto prototypes = network_->prototypes(which);
    auto use = torch::softmax(network_->prototypeLogits(tokens, which), -1).mean(0);
    const double least = kDeadShare / static_cast<double>(use.size(0));
    for (std::int64_t k = 0; k < use.size(0); ++k) {
      if (use[k].item<double>() >= least) continue;
      const auto busiest = use.argmax().item<std::int64_t>();
      const auto copied = torch::nn::functional::normalize(
          prototypes[busiest], torch::nn::functional::NormalizeFuncOptions().dim(0));
      prototypes[busiest].copy_(copied);
      prototypes[k].copy_(copied + 0.02 * torch::randn_like(copied));
      use[busiest] /= 2;
      use[k] = use[busiest];
    }
  }
}

bool ConceptTrainer::prototypesShareValues(std::mt19937_64 generator) {
  const torch::NoGradGuard no_gradient;
  // Of each concept: pairs known to differ and to agree, and how many of either are told wrongly.
  auto pairs = torch::zeros({static_cast<std::int64_t>(kNumConcepts), 2}), wrong = pairs.clone();
  const auto all = torch::ones({kChainImages, kChainImages}).triu(1);  // each pair once
  for (std::int64_t look = 0; look < kPairBatches; ++look) {
    const ChainBatch batch =
        drawBatch(images_, sampler_, options_.chains, kNoAugmentation, generator);
    const torch::Tensor tokens = readBatch(network_, batch.images).tokens;
    for (const Concept which : kConcepts) {
      const auto values =
          network_->prototypeLogits(tokens, which).argmax(-1).view({-1, kChainImages});
      const auto& changed = batch.changed[index(which)];
      const auto apart = (values.unsqueeze(1) != values.unsqueeze(2)).to(torch::kFloat);
      const auto differ = (changed.unsqueeze(1) != changed.unsqueeze(2)) * all;
      const auto agree = all - differ;
      const auto row = static_cast<std::int64_t>(index(which));
      pairs[row] += torch::stack({differ.sum(), agree.sum()});
      wrong[row] += torch::stack({(differ * (1 - apart)).sum(), (agree * apart).sum()});
    }
  }
  return (wrong > kMostWrongPairs * pairs).any().item<bool>();
}

ConceptLosses ConceptTrainer::drawerStep(std::mt19937_64& generator, double progress) {
  for (auto& parameter : network_->named_parameters())
    if (!draws(parameter.key())) parameter.value().set_requires_grad(false);
  const ChainBatch batch =
      drawBatch(images_, sampler_, options_.drawer_chains, kNoAugmentation, generator);
  ConceptLosses losses;
  auto total = torch::zeros({});
  if (batch.pairs.first.size(0) > 0) {
    const PairsToDraw pairs = choosePairs(batch.pairs, readBatch(network_, batch.images),
                                          options_.reconstructed_pairs, generator);
    const auto boxes = network_->drawer()->locateInCrop(pairs.tokens);
    const auto true_boxes = boundingBoxes(pairs.truth.slice(1, 4, 5));
    const bool settled = progress >= options_.settling;
    const DecodedObject drawn =
        network_->drawer()->forward(pairs.tokens, settled ? boxes : true_boxes);
    const auto sharpness = absoluteColorLoss(drawn, pairs.truth, options_.foreground_weight);
    const auto misplacement = torch::smooth_l1_loss(boxes, true_boxes, 1, 0.05);
    const auto reconstruction =
        pairReconstructionLoss(drawn, pairs.truth, options_.foreground_weight);
    const auto location = locationLoss(network_, pairs);
    losses.sharpness = sharpness.item<double>();
    losses.box = misplacement.item<double>();
    losses.reconstruction = reconstruction.item<double>();
    losses.location = location.item<double>();
    total = options_.reconstruction_weight * reconstruction + location +
            options_.sharpness_weight * sharpness + misplacement;
    if (settled) {
      const auto reading = readingLoss(network_, drawn, pairs.location, pairs.tokens);
      losses.reading = reading.item<double>();
      total = total + options_.reading_weight * reading;
    }
  }
  descend(total, progress, options_.drawer_rate_share);
  return losses;
}

void ConceptTrainer::descend(const torch::Tensor& loss, double progress, double rate_share) {
  // Without a gradient the optimizer leaves a parameter alone; with one of zero it would decay it.
  for (auto& parameter : network_->parameters()) parameter.mutable_grad() = torch::Tensor();
  if (!loss.requires_grad()) return;
  const double share = rate_share * learningRateShare(progress, options_.warm_up);
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
  const GeneratorGuard guard;
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
  identity_.write(archive);
  archive.write("network", network);
  archive.write("average", average);
  archive.write("optimizer", optimizer);
  archive.write("steps_done", torch::tensor(steps_done_));
  archive.write("repairs", torch::tensor(repairs_));
  std::ostringstream bytes;
  archive.save_to(bytes);
  return bytes.str();
}

void ConceptTrainer::restore(const std::string& checkpoint, const std::filesystem::path& path) {
  torch::serialize::InputArchive archive, network, average, optimizer;
  std::istringstream bytes(checkpoint);
  archive.load_from(bytes);
  identity_.check(archive, path);
  archive.read("network", network);
  archive.read("average", average);
  archive.read("optimizer", optimizer);
  torch::Tensor steps_done, repairs;
  archive.read("steps_done", steps_done);
  archive.read("repairs", repairs);
  network_->load(network);
  average_->load(average);
  optimizer_.load(optimizer);
  steps_done_ = steps_done.item<std::int64_t>();
  repairs_ = repairs.item<std::int64_t>();
}

}  // namespace conceptplan
