#pragma once

#include "conceptplan/domain/simulation/task_generator.hpp"

namespace conceptplan::testing {

/// A test task of a level.
inline Task testTask(int level, int number) {
  TaskOptions options;
  options.level = level;
  options.split = Split::kTest;
  options.seed = 7;
  return TaskGenerator(options).task(number);
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
