#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "conceptplan/pipeline/evaluation.hpp"

namespace conceptplan {

/// How predicted frames look, and whether they say what the plan says, over the tasks of one level.
struct FrameEvaluationRow {
  std::string set;  ///< see `setName`
  int level = 1;
  std::size_t steps = 0;  ///< steps of the references, each predicted from the true picture
  double psnr_db = 0;     ///< mean over them, of the whole frame
  double ssim = 0;        ///< mean over them, of the whole frame
  std::size_t planned_steps =
      0;  ///< steps of the first plans of `belief`, drawn from the first picture
  double read_back =
      0;  ///< percent of them in whose frame the target reads as all six planned symbols
  std::size_t unplanned =
      0;  ///< tasks without such a plan: none was found, or the target is hidden
};

/// @throws InputError if the set does not hold the pictures of all steps.
void requireAllFrames(const TaskDataset& tasks);

/// Draws every step of every task. Steps whose target is hidden in a picture are left out.
/// Of the options, planners and seed are not read.
/// @returns a row for each level; nothing if cancelled
/// @throws InputError as `requireAllFrames`, and if a picture is damaged.
std::vector<FrameEvaluationRow> evaluateFrames(const TaskDataset& tasks, const Model& model,
                                               const EvaluationOptions& options);

}  // namespace conceptplan
