#include "conceptplan/domain/simulation/second_target.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"

namespace conceptplan {
namespace {

TEST(WithSecondTarget, TheReferenceMovesBothToTheirGoals) {
  for (int level = 2; level <= 4; ++level) {
    const TaskGenerator generator({.level = level, .seed = 3});
    for (int i = 0; i < 10; ++i) {
      RandomStream random{static_cast<std::uint64_t>(i)};
      const std::optional<Task> task = withSecondTarget(generator.task(i), random);
      if (!task) continue;
      ASSERT_EQ(task->further.size(), 1u);
      const FurtherTarget& second = task->further.front();
      EXPECT_NE(second.object, task->initial.target);
      EXPECT_NE(task->initial.objects[second.object].type, ObjectType::kDyer);
      EXPECT_NE(second.goal.cell, task->initial.objects[second.object].cell);
      EXPECT_TRUE(judge(*task, task->reference, task->moved).succeeded()) << task->id;
      EXPECT_FALSE(judge(*task, generator.task(i).reference).succeeded()) << task->id;
    }
  }
}

TEST(WithSecondTarget, TheSameDrawsGiveTheSameTask) {
  const Task task = TaskGenerator({.level = 3, .seed = 3}).task(1);
  RandomStream first{5};
  RandomStream again{5};
  EXPECT_EQ(withSecondTarget(task, first)->reference, withSecondTarget(task, again)->reference);
}

TEST(WithSecondTarget, NeedsAnObstacle) {
  RandomStream random{1};
  EXPECT_THROW(withSecondTarget(TaskGenerator({.level = 1}).task(0), random),
               std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
