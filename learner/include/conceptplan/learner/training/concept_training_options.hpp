#pragma once

#include <cstdint>
#include <string>

#include "conceptplan/learner/encoder_kind.hpp"
#include "conceptplan/learner/training/augmentation.hpp"

namespace conceptplan {

struct ConceptTrainingOptions {
  EncoderKind encoder = EncoderKind::kObjectCentred;
  std::int64_t encoder_steps = 2700;  ///< first phase: tokens, and from some step on the decoder
  /// Where values share a prototype after the second phase, the first one is taken again for so
  /// many steps, with the optimizer's averages forgotten, and the second one after it; at most so
  /// often.
  std::int64_t repair_steps = 400;
  std::int64_t most_repairs = 4;
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
  /// What the first weights are, e.g. the checksum of their file; empty if they are drawn. A
  /// checkpoint of others is refused.
  std::string start_from;
};

/// The paper's own networks, on whole frames as they are, with its losses and learning rates alone.
/// Source: the authors' page of arXiv 2310.03325. Ours are steps and chains, the rates' course, the
/// averaging of weights, and that depth, mask and the crop's place are drawn too, for frames.
ConceptTrainingOptions paperConceptTraining();

}  // namespace conceptplan
