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
  bool planned = false;
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

/// Draws the steps of the reference, each from the picture before it, and the first plan, from the
/// first picture.
FrameSums drawTask(const TaskDataset& tasks, const Task& task, const Model& model) {
  std::vector<RgbdImage> pictures;
  for (std::size_t step = 0; step <= task.reference.size(); ++step)
    pictures.push_back(tasks.frame(task, static_cast<int>(step)));
  const std::vector<Percept> percepts = model.perceive(pictures);
  const std::uint8_t target = targetOf(task);

  std::vector<Plan> plans;          // of one step each
  std::vector<std::size_t> before;  // the picture from which each starts
  for (std::size_t step = 0; step < task.reference.size(); ++step)
    if (const auto graph = graphOf(model, percepts[step], percepts[step + 1], target)) {
      plans.push_back(singleStep(*graph, task.reference[step]));
      before.push_back(step);
    }
  FrameSums sums;
  sums.steps = before.size();
  if (const auto graph = graphOf(model, percepts.front(), percepts.back(), target)) {
    const PlanResult result = BeliefPlanner().solve(*graph, PlanQuery{});
    if (!result.plans.empty()) {
      plans.push_back(result.plans.front());
      before.push_back(0);
    }
  }
  std::vector<RenderQuery> queries;
  for (std::size_t i = 0; i < plans.size(); ++i)
    queries.push_back({pictures[before[i]], percepts[before[i]], target, plans[i]});
  const std::vector<std::vector<RgbdImage>> drawn = model.render(queries);

  for (std::size_t i = 0; i < sums.steps; ++i) {
    const RgbdImage& truth = pictures[before[i] + 1];
    sums.psnr_db += peakSignalToNoise_dB(drawn[i].front(), truth);
    sums.ssim += structuralSimilarity(drawn[i].front(), truth);
  }
  sums.planned = plans.size() > sums.steps;
  if (!sums.planned) return sums;
  const std::vector<Percept> read = model.perceive(drawn.back());
  for (std::size_t step = 0; step < read.size(); ++step) {
    const std::size_t at = read[step].position(target);
    ++sums.planned_steps;
    if (at < read[step].beliefs.size() &&
        mostProbable(read[step].beliefs[at]) == plans.back().predicted[step])
      ++sums.read_back;
  }
  return sums;
}

}  // namespace

void requireAllFrames(const TaskDataset& tasks) {
  if (tasks.options().frames != Frames::kAll)
    throw InputError({{tasks.folder().string(), std::nullopt, std::nullopt, "frames",
                       "expected a set with the pictures of all steps; generate tasks --frames "
                       "all makes one"}});
}

std::vector<FrameEvaluationRow> evaluateFrames(const TaskDataset& tasks, const Model& model,
                                               const EvaluationOptions& options) {
  requireAllFrames(tasks);
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
      if (!sums[i].planned) ++row.unplanned;
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
