#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// Which pictures of a task are stored: none; the initial state and the goal; or every state of
/// the reference, step 0 the initial one.
enum class Frames { kNone, kEnds, kAll };

/// "none", "ends" or "all".
std::string_view name(Frames frames);
std::optional<Frames> framesNamed(std::string_view name);

/// What a set of tasks was drawn with.
struct TaskDatasetOptions {
  std::vector<int> levels{1};  ///< in [1, 4], each once; the tasks of one level follow each other
  int count = 1000;            ///< tasks a level
  Split split = Split::kTrain;
  ObjectSet objects = ObjectSet::kSeen;
  Combination combination = Combination::kAll;
  RenderDomain domain = RenderDomain::kStandard;
  Frames frames = Frames::kAll;
  std::uint64_t seed = 0;
  bool operator==(const TaskDatasetOptions&) const = default;
};

/// The tasks of the options, as `TaskGenerator` draws them.
/// @throws std::invalid_argument for a level twice, no level, a count below 1, and as
///   `TaskGenerator`.
std::vector<Task> drawTasks(const TaskDatasetOptions& options);

/// The steps of a task that are stored, ascending.
std::vector<int> storedSteps(const Task& task, Frames frames);

/// The world after the first `step` actions of the reference.
/// @throws std::invalid_argument for a step beyond the reference.
World worldAtStep(const Task& task, int step);

/// A set of tasks on disk. docs/datasets.md describes its files. Immutable, thread-safe.
class TaskDataset {
 public:
  /// Reads the tasks and checks them against their checksum, the options and the simulator;
  /// pictures stay on disk.
  /// @throws InputError with all faults: a file missing, damaged or of another version or kind, a
  ///   set whose generation was interrupted, tasks of another number or level than the options say,
  ///   another workbench than the standard one, a reference that is illegal or misses the goal.
  explicit TaskDataset(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  const TaskDatasetOptions& options() const { return options_; }
  const std::vector<Task>& tasks() const { return tasks_; }

  /// The picture of a task after `step` actions of its reference, checked against its checksums.
  /// @throws InputError if it is not stored, damaged or not 384 x 256.
  RgbdImage frame(const Task& task, int step) const;

 private:
  struct Files;

  std::filesystem::path folder_;
  TaskDatasetOptions options_;
  std::shared_ptr<const Files> files_;
  std::vector<Task> tasks_;
};

}  // namespace conceptplan
