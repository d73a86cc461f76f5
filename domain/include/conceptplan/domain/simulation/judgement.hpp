#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// Why a plan does not solve a task. The first that applies, in this order: no plan was found; the
/// first illegal action; what is wrong with the last state.
enum class Failure {
  kNoPlan,
  kOffWorkbench,
  kCollision,
  kNoDyer,
  kWrongPosition,
  kWrongColor,
  kWrongRotation
};

/// "no_plan", "off_workbench", "collision", "no_dyer", "wrong_position", "wrong_color" or
/// "wrong_rotation".
std::string_view name(Failure failure);

/// How good a plan is for a task.
struct Judgement {
  std::optional<Failure> failure;  ///< nothing if the plan solves the task

  /// Length of the reference over the length of the plan, 1 for two empty ones; nothing unless the
  /// plan solves the task. Source: the definition of ASE, Sec. IV of arXiv 2310.03325.
  std::optional<double> efficiency;

  /// Distance in cells from the last position to the goal's (FSD). The position follows all moves
  /// of the plan, on and beyond the workbench and through other objects; without a plan it is
  /// where the target starts. Of several targets it is the sum.
  double final_distance = 0;

  bool succeeded() const { return !failure; }
};

/// Replays a plan from the true initial state. A plan with an illegal action fails. Levels 1 and 2
/// ask for the goal's position, level 3 for its colour also, level 4 for its rotation also; each of
/// several targets must have its goal's.
/// @param moved the object that each action moves; empty: all move the task's target
/// @throws std::invalid_argument for a level outside 1 to 4, or as `replay`.
Judgement judge(const Task& task, const std::optional<ActionSequence>& plan,
                std::span<const std::size_t> moved = {});

}  // namespace conceptplan
