#pragma once

#include <memory>

#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/planners/symbol_graph.hpp"
#include "planners/learned_world.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan::testing {

/// A test task of a level.
inline Task testTask(int level, int number) {
  TaskOptions options;
  options.level = level;
  options.split = Split::kTest;
  options.seed = 7;
  return TaskGenerator(options).task(number);
}

/// A task as the learned model sees it.
inline std::shared_ptr<const SymbolGraph> graphOf(const Task& task) {
  return std::make_shared<SymbolGraph>(
      compile(learnedModel(), learnedRelabelling().problem(task), GridValidity()));
}

/// A task of the tiny world.
inline std::shared_ptr<const SymbolGraph> tinyGraph(const Symbols& start, const Symbols& goal) {
  return std::make_shared<SymbolGraph>(
      compile(tinyModel(), tinyProblem(start, goal), GridValidity()));
}

/// The target in a corner behind two obstacles.
inline Task lockedInTask() {
  Task task;
  task.level = 2;
  task.initial.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0},
                          {ObjectType::kPot, {1, 0}, 0, 0, 0},
                          {ObjectType::kEgg, {0, 1}, 0, 0, 0}};
  task.goal = task.initial.objects[0];
  task.goal.cell = {2, 4};
  return task;
}

}  // namespace conceptplan::testing
