#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/image.hpp"

namespace conceptplan {

/// Writes a set of tasks. The folder is a valid set only after `finish`; until then it can be
/// continued by a writer of the same options, which keeps the pictures that are complete.
class TaskDatasetWriter {
 public:
  /// A picture still to be written: `tasks()[task]` after `step` actions.
  struct PendingFrame {
    std::size_t task;
    int step;
  };

  /// Draws the tasks and begins or continues the set.
  /// @throws InputError if the folder holds another dataset or cannot be written.
  /// @throws std::invalid_argument as `drawTasks`.
  TaskDatasetWriter(const std::filesystem::path& folder, const TaskDatasetOptions& options);

  const std::vector<Task>& tasks() const { return tasks_; }

  /// The pictures that are not there yet, by task and step.
  std::vector<PendingFrame> pendingFrames() const;

  /// How many pictures the finished set has.
  std::size_t numFrames() const;

  /// Writes a picture. Thread-safe for different frames.
  /// @throws InputError, std::runtime_error as `writeRgbdImage`.
  void write(const PendingFrame& frame, const RgbdImage& image) const;

  /// Writes the checksums and declares the set complete.
  /// @throws InputError if a picture is missing.
  void finish() const;

 private:
  std::filesystem::path folder_;
  TaskDatasetOptions options_;
  std::vector<Task> tasks_;
};

}  // namespace conceptplan
