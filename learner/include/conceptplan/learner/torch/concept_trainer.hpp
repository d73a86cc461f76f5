#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>

#include "conceptplan/learner/tensor_file.hpp"
#include "conceptplan/learner/torch/checkpoint_identity.hpp"
#include "conceptplan/learner/torch/concept_network.hpp"
#include "conceptplan/learner/training/augmentation.hpp"
#include "conceptplan/learner/training/chain_sampler.hpp"
#include "conceptplan/learner/training/concept_images.hpp"

namespace conceptplan {

struct ConceptTrainingOptions {
  EncoderKind encoder = EncoderKind::kObjectCentred;
  std::int64_t encoder_steps = 2700;    ///< first phase: tokens, and from some step on the decoder
  std::int64_t sharpening_steps = 700;  ///< second phase: tokens become certain; no decoder
  std::int64_t drawer_steps = 5000;     ///< third phase: the drawer learns; 0 leaves it untrained
  std::int64_t chains = 24;             ///< chains a step, seven images each
  std::int64_t drawer_chains = 6;       ///< the same in the third phase
  double learning_rate = 1.5e-3;        ///< of AdamW, at the peak of a phase; cosine to a fiftieth
  double tokenizer_rate_share = 1;      ///< of the rate, for concept tokenizer and detokenizer
  double warm_up = 0.03;                ///< share of a phase in which the rate rises
  /// Share of the first phase after which the decoder learns too, its gradient reaching the encoder
  /// as in Eq. (3).
  double reconstruction_start = 0.5;
  std::int64_t reconstructed_pairs = 16;  ///< pairs a step that are drawn
  double foreground_weight = 10;          ///< of the object's pixels; 1 is the background's
  double disentangling_weight = 1;        ///< of Eq. (2)
  double pair_weight = 1;                 ///< of the pair likelihood
  double use_weight = 2.5;                ///< of the prototypes' even use
  double confidence_weight = 0.6;         ///< of the entropy of single images, in the second phase
  double reconstruction_weight = 10;      ///< of Eq. (1) and of the direct branch
  /// Steps between two looks for prototypes that no picture uses, in the first two phases.
  std::int64_t revival_interval = 100;
  double sharpness_weight = 2;   ///< of absolute errors of colours, in the third phase
  double reading_weight = 0.3;   ///< of drawn objects read again, in the third phase
  double drawer_rate_share = 2;  ///< of the rate, in the third phase
  /// Share of the third phase after which objects are drawn in the boxes that the drawer finds, not
  /// in their true ones, and are read again.
  double settling = 0.5;
  double averaging = 0.998;  ///< decay of the weights' moving average
  AugmentationOptions augmentation;
  std::uint64_t seed = 0;
};

/// The paper's own networks, on whole frames as they are, with its losses and learning rates alone.
/// Source: the authors' page of arXiv 2310.03325. Ours are steps and chains, the rates' course, the
/// averaging of weights, and that depth, mask and the crop's place are drawn too, for frames.
ConceptTrainingOptions paperConceptTraining();

class GeneratorGuard;

/// Losses of one step; those of what does not learn in it are 0.
struct ConceptLosses {
  double disentangling = 0;  ///< Eq. (2)
  double pair = 0;
  double use = 0;
  double confidence = 0;
  double reconstruction = 0;  ///< Eq. (1)
  double direct = 0;          ///< direct branch of Eq. (3)
  double location = 0;        ///< smooth absolute error of where the crop lies
  double sharpness = 0;       ///< absolute error of the colours
  double box = 0;             ///< smooth absolute error of the box in the crop, which spans -1 to 1
  double reading = 0;         ///< mean squared error of tokens, drawn and read again
};

/// Trains the concept network on chains of pairs: Eq. (3) of arXiv 2310.03325, with the pair
/// likelihood on prototypes beside it, in three phases. Each step draws from a generator of its
/// own, so that a resumed run takes the same steps. Torch's default generator is left as it was.
class ConceptTrainer {
 public:
  /// Keeps a reference to `images`.
  /// @throws std::invalid_argument if there are steps for the drawer, which whole frames do not
  /// have.
  ConceptTrainer(const ConceptImages& images, const ConceptTrainingOptions& options);

  /// Begins from those weights in place of random ones.
  /// @param path stands in the faults. @throws InputError if tensors are missing or misshaped.
  void startFrom(const NamedTensors& tensors, const std::filesystem::path& path);

  /// @pre not all steps are done
  ConceptLosses step();
  std::int64_t stepsDone() const { return steps_done_; }
  std::int64_t stepsInAll() const {
    return options_.encoder_steps + options_.sharpening_steps + options_.drawer_steps;
  }

  /// The network with the moving average of its weights; shares nothing with the one in training.
  ConceptNetwork averaged() const;

  /// All that a resumed run needs, and which run it is of.
  std::string checkpoint() const;
  /// @param path stands in the faults. @throws InputError that names what differs if the checkpoint
  /// is of another seed, other options or other images, or if it does not say of which.
  /// @throws c10::Error if the bytes are not a checkpoint.
  void restore(const std::string& checkpoint, const std::filesystem::path& path = "checkpoint");

 private:
  /// The guard, which holds the seed, lives while the networks draw their weights.
  ConceptTrainer(const ConceptImages& images, const ConceptTrainingOptions& options,
                 const GeneratorGuard& guard);

  /// `progress` is the point of a phase, in 0..1.
  ConceptLosses tokenStep(std::mt19937_64& generator, double progress, bool sharpening);
  ConceptLosses drawerStep(std::mt19937_64& generator, double progress);
  /// Gives each prototype that is hardly used a place beside the one that is used most: there, two
  /// values share one, and a softmax passes hardly a gradient to a prototype out of reach.
  /// Source: the random restarts of Sec. 3.1 of Jukebox, arXiv 2005.00341.
  void revivePrototypes(std::mt19937_64& generator);
  void descend(const torch::Tensor& loss, double progress, double rate_share);

  const ConceptImages& images_;
  ConceptTrainingOptions options_;
  CheckpointIdentity identity_;
  ChainSampler sampler_;
  ConceptNetwork network_;
  ConceptNetwork average_;
  torch::optim::AdamW optimizer_;
  std::int64_t steps_done_ = 0;
};

}  // namespace conceptplan
