#include "conceptplan/domain/simulation/judgement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

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

std::optional<Failure> mismatch(const World& last, const Task& task) {
  const std::vector<FurtherTarget> targets = targetsOf(task);
  const auto differs = [&](auto part) {
    return std::ranges::any_of(targets, [&](const FurtherTarget& target) {
      return last.objects[target.object].*part != target.goal.*part;
    });
  };
  if (differs(&ObjectState::cell)) return Failure::kWrongPosition;
  if (task.level >= 3 && differs(&ObjectState::color)) return Failure::kWrongColor;
  if (task.level >= 4 && differs(&ObjectState::rotation)) return Failure::kWrongRotation;
  return std::nullopt;
}

}  // namespace

std::string_view name(Failure failure) {
  constexpr std::array<std::string_view, 7> kNames{"no_plan",       "off_workbench",  "collision",
                                                   "no_dyer",       "wrong_position", "wrong_color",
                                                   "wrong_rotation"};
  return kNames.at(static_cast<std::size_t>(failure));
}

Judgement judge(const Task& task, const std::optional<ActionSequence>& plan,
                std::span<const std::size_t> moved) {
  if (task.level < 1 || task.level > 4)
    throw std::invalid_argument("level must be in [1, 4], not " + std::to_string(task.level));
  const ActionSequence actions = plan.value_or(ActionSequence{});
  const Replay result = replay(task.initial, actions, moved);

  Judgement judgement;
  if (!plan) {
    judgement.failure = Failure::kNoPlan;
  } else if (result.obstruction) {
    judgement.failure = failureOf(*result.obstruction);
  } else {
    judgement.failure = mismatch(result.world, task);
  }
  if (!judgement.failure)
    judgement.efficiency = actions.empty() ? 1.0
                                           : static_cast<double>(task.reference.size()) /
                                                 static_cast<double>(actions.size());

  std::vector<ObjectState> last = task.initial.objects;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    Cell& cell = last[movedObject(task.initial, moved, i)].cell;
    cell = cellAfter(cell, actions[i]);
  }
  for (const FurtherTarget& target : targetsOf(task)) {
    const Cell cell = last[target.object].cell;
    judgement.final_distance +=
        std::hypot(cell.x - target.goal.cell.x, cell.y - target.goal.cell.y);
  }
  return judgement;
}

}  // namespace conceptplan
