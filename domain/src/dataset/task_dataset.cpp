#include "conceptplan/domain/dataset/task_dataset.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "dataset/manifest.hpp"
#include "dataset/task_files.hpp"
#include "dataset/task_record.hpp"

namespace conceptplan {
namespace {

constexpr std::array<std::string_view, 3> kFrames{"none", "ends", "all"};

/// Faults of more lines than this are not read out one by one.
constexpr std::size_t kMostFaults = 100;

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

std::string_view name(Frames frames) { return kFrames.at(static_cast<std::size_t>(frames)); }

std::optional<Frames> framesNamed(std::string_view name) {
  for (std::size_t i = 0; i < kFrames.size(); ++i)
    if (kFrames[i] == name) return static_cast<Frames>(i);
  return std::nullopt;
}

std::vector<Task> drawTasks(const TaskDatasetOptions& options) {
  if (options.levels.empty()) throw std::invalid_argument("a set of tasks needs a level");
  if (options.count < 1)
    throw std::invalid_argument("count must be at least 1, not " + std::to_string(options.count));
  std::vector<Task> tasks;
  for (auto level = options.levels.begin(); level != options.levels.end(); ++level) {
    if (std::find(options.levels.begin(), level, *level) != level)
      throw std::invalid_argument("level " + std::to_string(*level) + " is named twice");
    const TaskGenerator generator({.level = *level,
                                   .split = options.split,
                                   .objects = options.objects,
                                   .combination = options.combination,
                                   .seed = options.seed});
    for (int i = 0; i < options.count; ++i) tasks.push_back(generator.task(i));
  }
  return tasks;
}

std::vector<int> storedSteps(const Task& task, Frames frames) {
  const int last = static_cast<int>(task.reference.size());
  std::vector<int> steps;
  for (int step = 0; step <= last; ++step)
    if (frames == Frames::kAll || (frames == Frames::kEnds && (step == 0 || step == last)))
      steps.push_back(step);
  return steps;
}

World worldAtStep(const Task& task, int step) {
  if (step < 0 || step > static_cast<int>(task.reference.size()))
    throw std::invalid_argument("step " + std::to_string(step) + " of the " +
                                std::to_string(task.reference.size()) + " of task " + task.id);
  return replay(task.initial, {task.reference.begin(), task.reference.begin() + step}).world;
}

std::filesystem::path frameStem(const Task& task, int step) {
  const std::string number = (step < 10 ? "0" : "") + std::to_string(step);
  return std::filesystem::path("images") / task.id / number;
}

std::vector<Task> readTasks(const std::filesystem::path& folder,
                            const TaskDatasetOptions& options) {
  const std::filesystem::path path = folder / kTasksName;
  std::istringstream lines(readFile(path));
  std::vector<Task> tasks;
  std::vector<Fault> faults;
  const auto count = static_cast<std::size_t>(options.count);
  for (std::string line; faults.size() < kMostFaults && std::getline(lines, line);) {
    const std::size_t level = tasks.size() / count, earlier_faults = faults.size();
    Fault origin{path.string(), static_cast<int>(tasks.size() + 1), {}, "", ""};
    tasks.push_back(parseTaskRecord(line, origin, faults));
    if (faults.size() > earlier_faults || level >= options.levels.size() ||
        tasks.back().level == options.levels[level])
      continue;
    origin.key = "level";
    origin.message = "expected " + std::to_string(options.levels[level]) + ", found " +
                     std::to_string(tasks.back().level);
    faults.push_back(std::move(origin));
  }
  const std::size_t expected = options.levels.size() * count;
  if (faults.empty() && tasks.size() != expected)
    faults.push_back(
        {path.string(),
         {},
         {},
         "",
         "expected " + std::to_string(expected) + " tasks, found " + std::to_string(tasks.size())});
  if (!faults.empty()) throw InputError(std::move(faults));
  return tasks;
}

struct TaskDataset::Files {
  std::map<std::string, FileChecksum> by_path;

  /// What is wrong with a file of the set.
  std::vector<Fault> faults(const std::filesystem::path& folder,
                            const std::filesystem::path& path) const {
    const auto found = by_path.find(path.generic_string());
    if (found != by_path.end()) return faultsOf(folder, found->second);
    return {{(folder / path).string(), {}, {}, "", "is not a file of this dataset"}};
  }
};

TaskDataset::TaskDataset(const std::filesystem::path& folder) : folder_(folder) {
  const Manifest manifest = readManifest(folder, "tasks");
  options_ = taskOptions(manifest, folder);
  auto files = std::make_shared<Files>();
  for (const FileChecksum& file : readChecksums(folder, manifest))
    files->by_path.emplace(file.path, file);
  std::vector<Fault> faults = files->faults(folder, kTasksName);
  if (!faults.empty()) throw InputError(std::move(faults));
  files_ = std::move(files);
  tasks_ = readTasks(folder, options_);
}

RgbdImage TaskDataset::frame(const Task& task, int step) const {
  if (options_.frames != Frames::kAll &&
      !std::ranges::binary_search(storedSteps(task, options_.frames), step))
    throw InputError({{folder_.string(),
                       {},
                       {},
                       "frames",
                       "the set has no picture of step " + std::to_string(step) + " of " + task.id +
                           ": it was made with --frames " + std::string(name(options_.frames)) +
                           "; generate tasks --frames all makes one with the pictures of all " +
                           "steps, --frames ends one with those of start and goal"}});
  const RgbdPaths paths = rgbdPaths(frameStem(task, step));
  std::vector<Fault> faults;
  for (const std::filesystem::path& path : {paths.rgb, paths.depth, paths.mask})
    std::ranges::move(files_->faults(folder_, path), std::back_inserter(faults));
  if (!faults.empty()) throw InputError(std::move(faults));
  RgbdImage image =
      readRgbdImage({folder_ / paths.rgb, folder_ / paths.depth, folder_ / paths.mask});
  if (image.width != kFrameWidth || image.height != kFrameHeight)
    throw InputError({{(folder_ / paths.rgb).string(),
                       {},
                       {},
                       "rgb",
                       "expected " + sizeText(kFrameWidth, kFrameHeight) + " pixels, found " +
                           sizeText(image.width, image.height)}});
  return image;
}

}  // namespace conceptplan
