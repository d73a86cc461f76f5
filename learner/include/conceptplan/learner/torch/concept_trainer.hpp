#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>

#include "conceptplan/learner/tensor_file.hpp"
#include "conceptplan/learner/torch/checkpoint_identity.hpp"
#include "conceptplan/learner/torch/concept_network.hpp"
#include "conceptplan/learner/training/chain_sampler.hpp"
#include "conceptplan/learner/training/concept_images.hpp"
#include "conceptplan/learner/training/concept_training_options.hpp"

namespace conceptplan {

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
  /// Of the first two phases; more once they are taken again, for a repair.
  std::int64_t tokenSteps() const {
    return options_.encoder_steps + options_.sharpening_steps +
           repairs_ * (options_.repair_steps + options_.sharpening_steps);
  }
  std::int64_t stepsInAll() const { return tokenSteps() + options_.drawer_steps; }

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
  /// Whether plain training pictures show that two values share a prototype, or one value has two:
  /// pairs known to differ that are in one, or pairs known to agree that are not.
  bool prototypesShareValues(std::mt19937_64 generator);
  void descend(const torch::Tensor& loss, double progress, double rate_share);

  const ConceptImages& images_;
  ConceptTrainingOptions options_;
  CheckpointIdentity identity_;
  ChainSampler sampler_;
  ConceptNetwork network_;
  ConceptNetwork average_;
  torch::optim::AdamW optimizer_;
  std::int64_t steps_done_ = 0;
  std::int64_t repairs_ = 0;  ///< times that the first two phases were taken again
};

}  // namespace conceptplan
