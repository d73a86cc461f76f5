#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/learner/disentanglement/disentanglement_scores.hpp"
#include "conceptplan/pipeline/model.hpp"

namespace conceptplan {

struct ConceptEvaluationOptions {
  std::uint64_t seed = 0;  ///< of the disentanglement measures
  std::function<void(std::size_t done, std::size_t total)> progress;
  const std::atomic<bool>* cancel = nullptr;  ///< evaluation ends soon after it turns true
};

/// How well a model reads single objects. Shares are in [0, 1].
struct ConceptEvaluation {
  std::string set;           ///< e.g. "test/standard"
  std::size_t pictures = 0;  ///< 0 if cancelled
  /// Share of pictures whose nearest symbol stands for the true value.
  std::array<double, kNumConcepts> accuracy{};
  double all_right = 0;      ///< share of pictures with all six right
  double fit_no_symbol = 0;  ///< share that `Symbolizer::fits` or `Model::recognises` denies
  /// Expected calibration error of the symbols' probabilities, see `calibrationError`. A value for
  /// which no symbol stands counts as told wrongly.
  std::array<double, kNumConcepts> calibration_error{};
  DisentanglementScores disentanglement;  ///< of the tokens, see `tokenScores`
};

/// The seed of a set decides, as that of a model's training does, which combinations its split has.
/// @throws InputError if they differ, so that training may have seen what the set holds out.
void requireSameSplit(const ConceptDataset& data, const Model& model);

/// Reads every picture of the set with one thread.
/// @throws InputError as `requireSameSplit`, and if a picture is damaged.
/// @throws std::invalid_argument if the set is too small to measure disentanglement on.
ConceptEvaluation evaluateConcepts(const ConceptDataset& data, const Model& model,
                                   const ConceptEvaluationOptions& options = {});

}  // namespace conceptplan
