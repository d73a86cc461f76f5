#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset.hpp"

namespace conceptplan {

/// How a dataset is made; what is made does not depend on it.
struct GenerationControl {
  int jobs = 1;  ///< threads, each with a renderer of its own

  /// Called with the pictures that are there and those of the finished set; by one thread at a
  /// time, but not always the same.
  std::function<void(std::size_t done, std::size_t total)> progress = {};

  const std::atomic<bool>* cancel = nullptr;  ///< generation ends soon after it turns true
};

/// Draws tasks and renders their pictures into a `TaskDataset`. The same options give the same
/// bytes at any number of jobs. If it is cancelled or fails, the pictures that are complete stay,
/// and the same call continues with the others.
/// @returns whether the set is complete; false if it was cancelled
/// @throws InputError if the folder holds another dataset or cannot be written.
/// @throws std::invalid_argument as `drawTasks`, and for jobs below 1.
bool generateTasks(const std::filesystem::path& folder, const TaskDatasetOptions& options,
                   const GenerationControl& control);

/// Renders a part of the concept set into a `ConceptDataset`, likewise; what stays are complete
/// shards.
/// @throws std::invalid_argument for samples outside [1, 20], and for jobs below 1.
bool generateConcepts(const std::filesystem::path& folder, const ConceptDatasetOptions& options,
                      const GenerationControl& control);

}  // namespace conceptplan
