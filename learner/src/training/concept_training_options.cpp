#include "conceptplan/learner/training/concept_training_options.hpp"

namespace conceptplan {

ConceptTrainingOptions paperConceptTraining() {
  ConceptTrainingOptions options;
  options.encoder = EncoderKind::kFullFrame;
  options.chains = 8;
  options.reconstruction_start = 0;
  options.most_repairs = 0;
  options.sharpening_steps = 0;
  options.drawer_steps = 0;
  options.learning_rate = 3e-4;
  options.tokenizer_rate_share = 1.0 / 30;
  options.reconstruction_weight = 1;
  options.pair_weight = 0;
  options.use_weight = 0;
  options.confidence_weight = 0;
  options.foreground_weight = 1;
  options.augmentation = kNoAugmentation;
  return options;
}

}  // namespace conceptplan
