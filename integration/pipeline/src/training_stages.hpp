#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/learner/torch/concept_trainer.hpp"
#include "conceptplan/learner/torch/vict_trainer.hpp"
#include "conceptplan/pipeline/training.hpp"

namespace conceptplan::training {

/// Sizes and options of a profile.
struct Profile {
  std::string name;
  int concept_samples = 6;  ///< colour samples of each training combination
  int tasks_per_level = 240;
  std::size_t symbol_images = 8000;     ///< training images that are clustered
  std::size_t synthesis_frames = 2600;  ///< most frames that ViCT keeps in memory
  ConceptTrainingOptions concepts;
  VictTrainingOptions vict;
};

/// @throws InputError for an unknown name.
Profile profileNamed(const std::string& name);

/// One call of `train`: its options and how to tell of it.
struct Run {
  const TrainingOptions& options;
  const TrainingControl& control;
  Profile profile;

  bool cancelled() const { return control.cancel != nullptr && *control.cancel; }
  void report(const TrainingProgress& progress) const;
  /// Appends a line to MODEL/training.jsonl.
  void log(const std::string& json_line) const;
  std::filesystem::path checkpoint(TrainingStage stage) const;
};

/// Checks that what is there of a stage's datasets was made with the options of the run.
/// @throws InputError that names what differs.
void checkData(const Run& run, TrainingStage stage);

/// The datasets, generated if missing; nothing if cancelled meanwhile. @throws as `checkData`.
std::optional<ConceptDataset> conceptData(const Run& run, Split split);
std::optional<TaskDataset> taskData(const Run& run);

/// Each stage writes its file and adds to the manifest's measures. @returns false if cancelled.
bool trainConcepts(const Run& run, ModelManifest& manifest);
bool makeSymbols(const Run& run, ModelManifest& manifest);
bool countTransitions(const Run& run, ModelManifest& manifest);
bool trainVict(const Run& run, ModelManifest& manifest);

}  // namespace conceptplan::training
