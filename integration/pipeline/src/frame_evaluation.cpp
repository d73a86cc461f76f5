#include "conceptplan/pipeline/frame_evaluation.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "conceptplan/domain/image_quality.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"
#include "conceptplan/pipeline/parallel_work.hpp"
#include "conceptplan/pipeline/solve.hpp"
#include "conceptplan/planners/belief_planner.hpp"

namespace conceptplan {
namespace {

/// Sums over the steps of one task.
struct FrameSums {
  std::size_t steps = 0;
  double psnr_db = 0;
  double ssim = 0;
  std::size_t planned_steps = 0;
  std::size_t read_back = 0;
};

std::uint8_t targetOf(const Task& task) {
  return static_cast<std::uint8_t>(task.initial.target + 1);
}

/// The graph of what two pictures show; nothing if the target is hidden in one of them.
std::optional<SymbolGraph> graphOf(const Model& model, const Percept& from, const Percept& to,
                                   std::uint8_t target) {
  const FclValidity validity;
  try {
    return compile(model.symbolic(), problemOf(from, to, target), validity);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// One action with the symbols that most probably follow.
Plan singleStep(const SymbolGraph& graph, Action action) {
  Plan plan;
  plan.actions = {action};
  const auto next = graph.transitions(graph.mostProbableStart(), action);
  plan.predicted = {graph.symbols(next.front().state)};
  return plan;
}

void drawReference(const std::vector<RgbdImage>& frames, const std::vector<Percept>& percepts,
                   const Task& task, const Model& model, FrameSums& sums) {
  for (std::size_t step = 0; step < task.reference.size(); ++step) {
    const auto graph = graphOf(model, percepts[step], percepts[step + 1], targetOf(task));
    if (!graph) continue;
    const RgbdImage drawn = model
                                .render(frames[step], percepts[step], targetOf(task),
                                        singleStep(*graph, task.reference[step]))
                                .front();
    ++sums.steps;
    sums.psnr_db += peakSignalToNoise_dB(drawn, frames[step + 1]);
    sums.ssim += structuralSimilarity(drawn, frames[step + 1]);
  }
}

void drawPlan(const RgbdImage& first, const Percept& initial, const Percept& goal, const Task& task,
              const Model& model, FrameSums& sums) {
  const auto graph = graphOf(model, initial, goal, targetOf(task));
  if (!graph) return;
  const PlanResult result = BeliefPlanner().solve(*graph, PlanQuery{});
  if (result.plans.empty()) return;
  const Plan& plan = result.plans.front();
  const std::vector<RgbdImage> drawn = model.render(first, initial, targetOf(task), plan);
  const std::vector<Percept> percepts = model.perceive(drawn);
  for (std::size_t step = 0; step < drawn.size(); ++step) {
    const Percept& read = percepts[step];
    const std::size_t at = read.position(targetOf(task));
    ++sums.planned_steps;
    if (at < read.beliefs.size() && mostProbable(read.beliefs[at]) == plan.predicted[step])
      ++sums.read_back;
  }
}

FrameSums drawTask(const TaskDataset& tasks, const Task& task, const Model& model) {
  std::vector<RgbdImage> frames;
  for (std::size_t step = 0; step <= task.reference.size(); ++step)
    frames.push_back(tasks.frame(task, static_cast<int>(step)));
  const std::vector<Percept> percepts = model.perceive(frames);
  FrameSums sums;
  drawReference(frames, percepts, task, model, sums);
  drawPlan(frames.front(), percepts.front(), percepts.back(), task, model, sums);
  return sums;
}

}  // namespace

std::vector<FrameEvaluationRow> evaluateFrames(const TaskDataset& tasks, const Model& model,
                                               const EvaluationOptions& options) {
  if (tasks.options().frames != Frames::kAll)
    throw InputError({{tasks.folder().string(), std::nullopt, std::nullopt, "frames",
                       "expected a set with the pictures of all steps; generate tasks --frames "
                       "all makes one"}});
  const std::size_t total = tasks.tasks().size();
  std::vector<FrameSums> sums(total);
  std::size_t done = 0;
  std::mutex mutex;
  const auto evaluateTask = [&](std::size_t i) {
    sums[i] = drawTask(tasks, tasks.tasks()[i], model);
    const std::scoped_lock lock(mutex);
    if (options.progress) options.progress(++done, total);
  };
  workInParallel(total, options.jobs, options.cancel, [&]() -> Worker { return evaluateTask; });
  if (options.cancel != nullptr && *options.cancel) return {};

  std::vector<FrameEvaluationRow> rows;
  for (const int level : tasks.options().levels) {
    FrameEvaluationRow row;
    row.set = setName(tasks.options());
    row.level = level;
    for (std::size_t i = 0; i < total; ++i) {
      if (tasks.tasks()[i].level != level) continue;
      row.steps += sums[i].steps;
      row.psnr_db += sums[i].psnr_db;
      row.ssim += sums[i].ssim;
      row.planned_steps += sums[i].planned_steps;
      row.read_back += static_cast<double>(sums[i].read_back);
    }
    const auto steps = static_cast<double>(std::max<std::size_t>(1, row.steps));
    row.psnr_db /= steps;
    row.ssim /= steps;
    row.read_back *= 100.0 / static_cast<double>(std::max<std::size_t>(1, row.planned_steps));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace conceptplan
