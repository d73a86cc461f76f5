#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/torch/causal_transition.hpp"
#include "conceptplan/learner/torch/checkpoint_identity.hpp"
#include "conceptplan/learner/torch/frame_synthesizer.hpp"
#include "conceptplan/learner/torch/vict_losses.hpp"
#include "conceptplan/learner/training/task_sequences.hpp"

namespace conceptplan {

struct VictTrainingOptions {
  std::int64_t transition_steps = 3000;
  std::int64_t transition_batch = 256;
  std::int64_t synthesis_steps = 3000;
  std::int64_t synthesis_batch = 12;
  double learning_rate = 1e-3;  ///< of Adam, at its peak; cosine decay to a fiftieth
  double averaging = 0.998;     ///< decay of the synthesizer's moving average
  std::uint64_t seed = 0;
  /// What sequences and learner were made with, e.g. the checksums of the model's files; a
  /// checkpoint of another source is refused.
  std::string source;
};

class GeneratorGuard;

/// Trains ViCT in two phases: the causal transition on tokens, then the frame synthesizer on
/// windows with objects as the transition predicts them. The paper trains both at once; since the
/// concept learner is fixed, the token term has the same minimum alone, at a fraction of the cost.
/// Each step draws from a generator of its own, so that a resumed run takes the same steps.
/// Torch's default generator is left as it was.
class VictTrainer {
 public:
  /// Keeps references to both.
  VictTrainer(const std::vector<TaskSequence>& sequences, const ConceptLearner& learner,
              const VictTrainingOptions& options);

  VictLosses step();
  std::int64_t stepsDone() const { return steps_done_; }
  std::int64_t stepsInAll() const { return options_.transition_steps + options_.synthesis_steps; }

  /// Parameters as `VisualTransition` takes them.
  NamedTensors tensors() const;

  /// All that a resumed run needs, and which run it is of.
  std::string checkpoint() const;
  /// @param path stands in the faults. @throws InputError that names what differs if the checkpoint
  /// is of another seed, other options, pictures or actions, or if it does not say of which.
  /// @throws c10::Error if the bytes are not a checkpoint.
  void restore(const std::string& checkpoint, const std::filesystem::path& path = "checkpoint");

 private:
  /// The guard, which holds the seed, lives while the networks draw their weights.
  VictTrainer(const std::vector<TaskSequence>& sequences, const ConceptLearner& learner,
              const VictTrainingOptions& options, const GeneratorGuard& guard);

  VictLosses transitionStep(std::mt19937_64& generator);
  VictLosses synthesisStep(std::mt19937_64& generator);
  void setLearningRate(torch::optim::AdamW& optimizer, double progress) const;

  const std::vector<TaskSequence>& sequences_;
  const ConceptLearner& learner_;
  VictTrainingOptions options_;
  CheckpointIdentity identity_;
  CausalTransition transition_;
  FrameSynthesizer synthesizer_;
  FrameSynthesizer average_;
  torch::optim::AdamW transition_optimizer_;
  torch::optim::AdamW synthesis_optimizer_;
  std::int64_t steps_done_ = 0;
};

}  // namespace conceptplan
