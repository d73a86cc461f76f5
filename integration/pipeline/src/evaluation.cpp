#include "conceptplan/pipeline/evaluation.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"
#include "conceptplan/pipeline/parallel_work.hpp"
#include "conceptplan/pipeline/solve.hpp"

namespace conceptplan {
namespace {

/// What becomes of one task.
struct TaskResult {
  std::vector<Evaluation> plans;  ///< of each planner
  ToldObjects seen_types, unseen_types;
};

/// Counts the objects of the first picture.
void countObjects(const Task& task, const TaskReading& read, TaskResult& result) {
  const Percept& initial = read.initial;
  for (std::size_t i = 0; i < initial.instances.size(); ++i) {
    const std::size_t at = initial.instances[i] - 1U;
    if (at >= task.initial.objects.size()) continue;
    const bool seen = static_cast<std::size_t>(task.initial.objects[at].type) < kNumSeenTypes;
    ToldObjects& count = seen ? result.seen_types : result.unseen_types;
    ++count.objects;
    if (isLikeNoneLearned(initial.fits[i], read.initial_recognised[i])) ++count.told;
  }
}

void add(const ToldObjects& part, ToldObjects& sum) {
  sum.objects += part.objects;
  sum.told += part.told;
}

/// The problem that two pictures pose; nothing if the target is hidden in one of them.
std::optional<SymbolicProblem> readProblem(const Task& task, const TaskReading& read) {
  try {
    return problemOf(read.initial, read.goal, static_cast<std::uint8_t>(task.initial.target + 1));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

EvaluationRow rowOf(const TaskDataset& tasks, int level, const std::string& planner,
                    const std::vector<TaskResult>& results, std::size_t column) {
  EvaluationRow row;
  row.planner = planner;
  row.set = setName(tasks.options());
  row.level = level;
  double top1 = 0, top5 = 0, efficiency = 0, distance = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (tasks.tasks()[i].level != level) continue;
    const Evaluation& result = results[i].plans[column];
    add(results[i].seen_types, row.seen_types);
    add(results[i].unseen_types, row.unseen_types);
    ++row.tasks;
    distance += result.best.final_distance;
    top5 += result.top5 ? 1 : 0;
    if (result.best.succeeded()) {
      top1 += 1;
      efficiency += *result.best.efficiency;
    } else {
      ++row.failures[std::string(name(*result.best.failure))];
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, row.tasks));
  row.asacc_top1 = 100 * top1 / count;
  row.asacc_top5 = 100 * top5 / count;
  row.ase = top1 > 0 ? efficiency / top1 : 0;
  row.fsd = distance / count;
  return row;
}

}  // namespace

std::string setName(const TaskDatasetOptions& options) {
  std::string set(name(options.split));
  for (const std::string_view part : {name(options.objects), name(options.domain)})
    set += "/" + std::string(part);
  if (options.combination == Combination::kUnseenTask) set += "/unseen-task";
  return set;
}

std::vector<EvaluationRow> evaluate(const TaskDataset& tasks, const Model& model,
                                    const PlannerRegistry& registry,
                                    const EvaluationOptions& options) {
  std::vector<std::unique_ptr<Planner>> planners;
  for (const std::string& planner : options.planners) planners.push_back(registry.make(planner));

  const std::size_t total = tasks.tasks().size();
  std::vector<TaskResult> results(total);
  const FclValidity validity;
  std::size_t done = 0;
  std::mutex mutex;
  const auto evaluateTask = [&](std::size_t i) {
    const Task& task = tasks.tasks()[i];
    TaskResult& result = results[i];
    const TaskReading read = model.readTask(
        tasks.frame(task, 0), tasks.frame(task, static_cast<int>(task.reference.size())));
    countObjects(task, read, result);
    const auto problem = readProblem(task, read);
    std::optional<SymbolGraph> graph;
    if (problem) graph = compile(model.symbolic(), *problem, validity);
    for (const std::unique_ptr<Planner>& planner : planners) {
      PlanQuery query;
      query.top = kTopPlans;
      query.seed = options.seed;
      result.plans.push_back(
          evaluationOf(task, graph ? planner->solve(*graph, query).plans : std::vector<Plan>()));
    }
    const std::scoped_lock lock(mutex);
    if (options.progress) options.progress(++done, total);
  };
  workInParallel(total, options.jobs, options.cancel, [&]() -> Worker { return evaluateTask; });
  if (options.cancel != nullptr && *options.cancel) return {};

  std::vector<EvaluationRow> rows;
  for (std::size_t p = 0; p < planners.size(); ++p)
    for (const int level : tasks.options().levels)
      rows.push_back(rowOf(tasks, level, options.planners[p], results, p));
  return rows;
}

}  // namespace conceptplan
