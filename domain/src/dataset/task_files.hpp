#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan {

inline constexpr const char* kTasksName = "tasks.jsonl";

/// Where the three files of a picture lie, relative to the folder of the dataset, without their
/// endings.
std::filesystem::path frameStem(const Task& task, int step);

/// All lines of tasks.jsonl. @throws InputError with all faults, also for tasks of another number
/// or level than the options say.
std::vector<Task> readTasks(const std::filesystem::path& folder, const TaskDatasetOptions& options);

}  // namespace conceptplan
