#include "conceptplan/domain/simulation/judgement.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "conceptplan/domain/simulation/simulator.hpp"

namespace conceptplan {
namespace {

Failure failureOf(Obstruction obstruction) {
  switch (obstruction) {
    case Obstruction::kOffWorkbench:
      return Failure::kOffWorkbench;
    case Obstruction::kCollision:
      return Failure::kCollision;
    case Obstruction::kNoDyer:
      return Failure::kNoDyer;
  }
  throw std::invalid_argument("no obstruction " + std::to_string(static_cast<int>(obstruction)));
}

std::optional<Failure> mismatch(const ObjectState& last, const ObjectState& goal, int level) {
  if (last.cell != goal.cell) return Failure::kWrongPosition;
  if (level >= 3 && last.color != goal.color) return Failure::kWrongColor;
  if (level >= 4 && last.rotation != goal.rotation) return Failure::kWrongRotation;
  return std::nullopt;
}

}  // namespace

std::string_view name(Failure failure) {
  constexpr std::array<std::string_view, 7> kNames{"no_plan",       "off_workbench",  "collision",
                                                   "no_dyer",       "wrong_position", "wrong_color",
                                                   "wrong_rotation"};
  return kNames.at(static_cast<std::size_t>(failure));
}

Judgement judge(const Task& task, const std::optional<ActionSequence>& plan) {
  if (task.level < 1 || task.level > 4)
    throw std::invalid_argument("level must be in [1, 4], not " + std::to_string(task.level));
  const ActionSequence actions = plan.value_or(ActionSequence{});
  const Replay result = replay(task.initial, actions);

  Judgement judgement;
  if (!plan) {
    judgement.failure = Failure::kNoPlan;
  } else if (result.obstruction) {
    judgement.failure = failureOf(*result.obstruction);
  } else {
    judgement.failure = mismatch(result.world.objects[task.initial.target], task.goal, task.level);
  }
  if (!judgement.failure)
    judgement.efficiency = actions.empty() ? 1.0
                                           : static_cast<double>(task.reference.size()) /
                                                 static_cast<double>(actions.size());

  Cell last = task.initial.objects[task.initial.target].cell;
  for (const Action action : actions) last = cellAfter(last, action);
  judgement.final_distance = std::hypot(last.x - task.goal.cell.x, last.y - task.goal.cell.y);
  return judgement;
}

}  // namespace conceptplan
