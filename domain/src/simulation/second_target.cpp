#include "conceptplan/domain/simulation/second_target.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "conceptplan/domain/simulation/reference_planner.hpp"

namespace conceptplan {
namespace {

template <typename Value>
void shuffle(std::vector<Value>& values, RandomStream& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

std::vector<std::size_t> obstaclesOf(const World& world) {
  std::vector<std::size_t> obstacles;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    if (i != world.target && world.objects[i].type != ObjectType::kDyer) obstacles.push_back(i);
  }
  return obstacles;
}

/// The cells that the object may be sent to.
std::vector<Cell> goalCells(const Task& task, std::size_t object) {
  std::vector<Cell> cells;
  for (int y = 0; y < task.initial.workbench.rows; ++y) {
    for (int x = 0; x < task.initial.workbench.columns; ++x) {
      const Cell cell{x, y};
      bool free = cell != task.goal.cell && cell != task.initial.objects[object].cell;
      for (std::size_t i = 0; i < task.initial.objects.size(); ++i) {
        free = free && (i == task.initial.target || task.initial.objects[i].cell != cell);
      }
      if (free) cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace

std::optional<Task> withSecondTarget(Task task, RandomStream& random) {
  std::vector<std::size_t> obstacles = obstaclesOf(task.initial);
  if (obstacles.empty()) throw std::invalid_argument(task.id + " has no obstacle to be moved");
  shuffle(obstacles, random);
  for (const std::size_t object : obstacles) {
    FurtherTarget second{object, task.initial.objects[object]};
    if (task.level >= 3 && random.below(2) == 0) {
      const auto dyer =
          std::ranges::find(task.initial.objects, ObjectType::kDyer, &ObjectState::type);
      second.goal.color = dyer->color;
    }
    if (task.level >= 4) second.goal.rotation = random.between(0, 3);
    std::vector<Cell> cells = goalCells(task, object);
    shuffle(cells, random);
    for (const Cell cell : cells) {
      second.goal.cell = cell;
      task.further = {second};
      if (auto plan = shortestJointPlan(task)) {
        task.reference = std::move(plan->actions);
        task.moved = std::move(plan->moved);
        return task;
      }
    }
  }
  return std::nullopt;
}

}  // namespace conceptplan
