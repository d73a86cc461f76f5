#include "conceptplan/domain/dataset/dataset_state.hpp"
#include "conceptplan/pipeline/generation.hpp"
#include "training_stages.hpp"

namespace conceptplan::training {
namespace {

constexpr const char* kTaskFolder = "tasks-train";

const char* folderName(Split split) {
  return split == Split::kTrain ? "concepts-train" : "concepts-validation";
}

GenerationControl generationControl(const Run& run, const std::string& what) {
  return {run.options.jobs,
          [&run, what](std::size_t done, std::size_t total) {
            run.report({"data: " + what, done, total, ""});
          },
          run.control.cancel};
}

ConceptDatasetOptions conceptOptions(const Run& run, Split split) {
  return {split, split == Split::kTrain ? run.profile.concept_samples : 1, RenderDomain::kStandard,
          run.options.seed};
}

TaskDatasetOptions taskOptions(const Run& run) {
  TaskDatasetOptions options;
  options.levels = {1, 2, 3, 4};
  options.count = run.profile.tasks_per_level;
  options.combination = Combination::kUnseenTask;  // so that evaluation has unseen tasks
  options.seed = run.options.seed;
  return options;
}

}  // namespace

void checkData(const Run& run, TrainingStage stage) {
  const auto& data = run.options.data;
  switch (stage) {
    case TrainingStage::kMakeSymbols:
      datasetState(data / folderName(Split::kValidation), conceptOptions(run, Split::kValidation));
      [[fallthrough]];
    case TrainingStage::kLearnConcepts:
      datasetState(data / folderName(Split::kTrain), conceptOptions(run, Split::kTrain));
      return;
    case TrainingStage::kCountTransitions:
    case TrainingStage::kTrainVict:
      datasetState(data / kTaskFolder, taskOptions(run));
      return;
  }
}

std::optional<ConceptDataset> conceptData(const Run& run, Split split) {
  const std::string name = folderName(split);
  const auto folder = run.options.data / name;
  const ConceptDatasetOptions wanted = conceptOptions(run, split);
  if (datasetState(folder, wanted) != DatasetState::kComplete &&
      !generateConcepts(folder, wanted, generationControl(run, name)))
    return std::nullopt;
  return ConceptDataset(folder);
}

std::optional<TaskDataset> taskData(const Run& run) {
  const auto folder = run.options.data / kTaskFolder;
  const TaskDatasetOptions wanted = taskOptions(run);
  if (datasetState(folder, wanted) != DatasetState::kComplete &&
      !generateTasks(folder, wanted, generationControl(run, kTaskFolder)))
    return std::nullopt;
  return TaskDataset(folder);
}

}  // namespace conceptplan::training
