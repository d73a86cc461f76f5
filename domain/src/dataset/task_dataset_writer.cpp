#include "conceptplan/domain/dataset/task_dataset_writer.hpp"

#include <string>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "dataset/manifest.hpp"
#include "dataset/task_files.hpp"
#include "dataset/task_record.hpp"

namespace conceptplan {

TaskDatasetWriter::TaskDatasetWriter(const std::filesystem::path& folder,
                                     const TaskDatasetOptions& options)
    : folder_(folder), options_(options), tasks_(drawTasks(options)) {
  beginDataset(folder_, "tasks", toJson(options_));
  std::string lines;
  for (const Task& task : tasks_) lines += taskRecord(task) + '\n';
  writeFileAtomically(folder_ / kTasksName, lines);
  if (options_.frames == Frames::kNone) return;
  for (const Task& task : tasks_) createFolder(folder_ / "images" / task.id);
}

std::vector<TaskDatasetWriter::PendingFrame> TaskDatasetWriter::pendingFrames() const {
  std::vector<PendingFrame> pending;
  for (std::size_t i = 0; i < tasks_.size(); ++i) {
    for (const int step : storedSteps(tasks_[i], options_.frames)) {
      const RgbdPaths paths = rgbdPaths(folder_ / frameStem(tasks_[i], step));
      for (const std::filesystem::path& path : {paths.rgb, paths.depth, paths.mask}) {
        if (std::filesystem::exists(path)) continue;
        pending.push_back({i, step});
        break;
      }
    }
  }
  return pending;
}

std::size_t TaskDatasetWriter::numFrames() const {
  std::size_t count = 0;
  for (const Task& task : tasks_) count += storedSteps(task, options_.frames).size();
  return count;
}

void TaskDatasetWriter::write(const PendingFrame& frame, const RgbdImage& image) const {
  writeRgbdImage(folder_ / frameStem(tasks_.at(frame.task), frame.step), image);
}

void TaskDatasetWriter::finish() const {
  std::vector<std::string> paths{kTasksName};
  for (const Task& task : tasks_) {
    for (const int step : storedSteps(task, options_.frames)) {
      const RgbdPaths frame = rgbdPaths(frameStem(task, step));
      for (const std::filesystem::path& path : {frame.rgb, frame.depth, frame.mask})
        paths.push_back(path.generic_string());
    }
  }
  finishDataset(folder_, "tasks", toJson(options_), paths);
}

}  // namespace conceptplan
