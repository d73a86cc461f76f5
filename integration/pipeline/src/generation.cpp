#include "conceptplan/pipeline/generation.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/dataset/task_dataset_writer.hpp"
#include "conceptplan/domain/rendering/appearance.hpp"
#include "conceptplan/domain/rendering/renderer.hpp"
#include "conceptplan/pipeline/parallel_work.hpp"

namespace conceptplan {
namespace {

static_assert(kNumColorSamples == kColorSamples);

using PendingFrame = TaskDatasetWriter::PendingFrame;

/// Renders in numbered pieces, shared among threads with a renderer each, and counts pictures.
class Rendering {
 public:
  Rendering(const GenerationControl& control, std::size_t done, std::size_t total)
      : control_(control), done_(done), total_(total) {
    if (control.jobs < 1)
      throw std::invalid_argument("jobs must be at least 1, not " + std::to_string(control.jobs));
  }

  /// Calls `work(renderer, i)` for i in [0, count), until one throws or generation is cancelled.
  /// @returns whether all was done @throws what the first work that failed threw
  template <typename Work>
  bool run(std::size_t count, const Work& work) {
    if (control_.progress) control_.progress(done_, total_);
    workInParallel(count, control_.jobs, control_.cancel, [&work]() -> Worker {
      const auto renderer = std::make_shared<Renderer>();
      return [&work, renderer](std::size_t i) { work(*renderer, i); };
    });
    return !cancelled();
  }

  bool cancelled() const { return control_.cancel && *control_.cancel; }

  void count(std::size_t pictures) {
    const std::scoped_lock lock(mutex_);
    done_ += pictures;
    if (control_.progress) control_.progress(done_, total_);
  }

 private:
  const GenerationControl& control_;
  std::size_t done_;
  std::size_t total_;
  std::mutex mutex_;
};

/// Frames of one task share a room, which a renderer keeps: they stay together.
std::vector<std::span<const PendingFrame>> byTask(const std::vector<PendingFrame>& frames) {
  std::vector<std::span<const PendingFrame>> groups;
  for (auto begin = frames.begin(); begin != frames.end();) {
    const auto end = std::find_if(begin, frames.end(), [begin](const PendingFrame& frame) {
      return frame.task != begin->task;
    });
    groups.emplace_back(begin, end);
    begin = end;
  }
  return groups;
}

}  // namespace

bool generateTasks(const std::filesystem::path& folder, const TaskDatasetOptions& options,
                   const GenerationControl& control) {
  const TaskDatasetWriter writer(folder, options);
  const std::vector<PendingFrame> pending = writer.pendingFrames();
  const std::vector<std::span<const PendingFrame>> groups = byTask(pending);
  Rendering rendering(control, writer.numFrames() - pending.size(), writer.numFrames());
  const bool complete = rendering.run(groups.size(), [&](Renderer& renderer, std::size_t i) {
    for (const PendingFrame& frame : groups[i]) {
      if (rendering.cancelled()) return;
      const Task& task = writer.tasks()[frame.task];
      writer.write(
          frame, renderer.render(worldAtStep(task, frame.step), {task.appearance, options.domain}));
      rendering.count(1);
    }
  });
  if (complete) writer.finish();
  return complete;
}

bool generateConcepts(const std::filesystem::path& folder, const ConceptDatasetOptions& options,
                      const GenerationControl& control) {
  const ConceptDatasetWriter writer(folder, options);
  const std::vector<std::size_t> shards = writer.pendingShards();
  std::size_t total = 0;
  for (std::size_t shard = 0; shard < writer.numShards(); ++shard)
    total += writer.requests(shard).size();
  std::size_t missing = 0;
  for (const std::size_t shard : shards) missing += writer.requests(shard).size();

  Rendering rendering(control, total - missing, total);
  const bool complete = rendering.run(shards.size(), [&](Renderer& renderer, std::size_t i) {
    std::vector<ObjectCrop> crops;
    for (const auto& request : writer.requests(shards[i])) {
      if (rendering.cancelled()) return;
      crops.push_back(
          renderer.renderForeground({}, request.object, {request.appearance, options.domain}));
    }
    writer.write(shards[i], crops);
    rendering.count(crops.size());
  });
  if (complete) writer.finish();
  return complete;
}

}  // namespace conceptplan
