#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {

struct EvaluationOptions {
  std::vector<std::string> planners{"belief"};
  int jobs = 1;
  std::uint64_t seed = 0;
  std::function<void(std::size_t done, std::size_t total)> progress;
  const std::atomic<bool>* cancel = nullptr;  ///< evaluation ends soon after it turns true
};

/// What a set was drawn with, as "test/seen/standard".
std::string setName(const TaskDatasetOptions& options);

/// Objects in the first pictures of tasks, and how many of them are told to be like none that was
/// learned, see `Symbolizer::fits` and `Model::recognises`.
struct ToldObjects {
  std::size_t objects = 0;
  std::size_t told = 0;
};

/// The measures of one planner on the tasks of one level. Source: "Evaluation metrics", Sec. IV of
/// arXiv 2310.03325.
struct EvaluationRow {
  std::string learner = "scl";
  std::string planner;
  std::string set;  ///< see `setName`
  int level = 1;
  std::size_t tasks = 0;
  double asacc_top1 = 0;  ///< percent of tasks that the first plan solves
  double asacc_top5 = 0;  ///< percent of tasks that one of the first five plans solves
  double ase = 0;         ///< mean efficiency of the first plans that succeed; 0 if none does
  double fsd = 0;         ///< mean distance of the last position from the goal, cells
  std::map<std::string, std::size_t> failures;  ///< of first plans, by cause
  ToldObjects seen_types;                       ///< of types that training had; for any planner
  ToldObjects unseen_types;                     ///< of the other types
};

/// Reads the first and the last picture of every task, plans, and judges in the simulator.
/// @returns a row for each planner and level, in the order of the planners; nothing if cancelled
/// @throws InputError for an unknown planner, or a picture that is missing or damaged.
std::vector<EvaluationRow> evaluate(const TaskDataset& tasks, const Model& model,
                                    const PlannerRegistry& registry,
                                    const EvaluationOptions& options);

}  // namespace conceptplan
