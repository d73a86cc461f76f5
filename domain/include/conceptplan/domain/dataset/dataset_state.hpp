#pragma once

#include <filesystem>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset.hpp"

namespace conceptplan {

/// Whether a dataset is there, and whether its generation came to its end.
enum class DatasetState { kMissing, kInterrupted, kComplete };

/// What a folder holds of the dataset with those options; only dataset.json is read.
/// @returns `kMissing` if there is no dataset.json, nor a folder
/// @throws InputError if it holds another dataset, with every option that differs; and for a
///   dataset.json that is malformed or of another version.
DatasetState datasetState(const std::filesystem::path& folder, const TaskDatasetOptions& options);
DatasetState datasetState(const std::filesystem::path& folder,
                          const ConceptDatasetOptions& options);

}  // namespace conceptplan
