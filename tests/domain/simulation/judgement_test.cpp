#include "conceptplan/domain/simulation/judgement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "conceptplan/domain/simulation/task_generator.hpp"

namespace conceptplan {
namespace {

using enum Action;

/// A cup from (0, 0) to (1, 1), red to the dyer's green, one turn to the left; the dyer at (0, 1).
Task smallTask(int level) {
  Task task;
  task.level = level;
  task.initial.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0},
                          {ObjectType::kDyer, {0, 1}, 0, 2, 0},
                          {ObjectType::kEgg, {2, 1}, 0, 0, 0}};
  task.goal = {ObjectType::kCup, {1, 1}, 1, 2, 0};
  task.reference = {kChangeColor, kRotateLeft, kMoveRight, kMoveFront};
  return task;
}

TEST(Judge, TheReferenceIsPerfect) {
  for (int level = 1; level <= 4; ++level) {
    const TaskGenerator generator({.level = level, .seed = 9});
    for (int i = 0; i < 100; ++i) {
      const Task task = generator.task(i);
      const Judgement judgement = judge(task, task.reference);
      EXPECT_TRUE(judgement.succeeded()) << task.id;
      EXPECT_EQ(judgement.efficiency, 1.0);
      EXPECT_EQ(judgement.final_distance, 0.0);
    }
  }
}

TEST(Judge, EachLevelAsksForOneConceptMore) {
  const ActionSequence position{kMoveRight, kMoveFront};
  const ActionSequence color{kChangeColor, kMoveRight, kMoveFront};
  EXPECT_TRUE(judge(smallTask(1), position).succeeded());
  EXPECT_TRUE(judge(smallTask(2), position).succeeded());
  EXPECT_EQ(judge(smallTask(3), position).failure, Failure::kWrongColor);
  EXPECT_TRUE(judge(smallTask(3), color).succeeded());
  EXPECT_EQ(judge(smallTask(4), color).failure, Failure::kWrongRotation);
  EXPECT_TRUE(judge(smallTask(4), smallTask(4).reference).succeeded());
}

TEST(Judge, EfficiencyIsTheReferenceOverThePlan) {
  const Task task = smallTask(4);
  const ActionSequence detour{kChangeColor, kRotateLeft, kRotateLeft, kRotateRight,
                              kMoveRight,   kMoveFront,  kMoveFront,  kMoveBack};
  EXPECT_EQ(judge(task, detour).efficiency, 0.5);
  EXPECT_EQ(judge(task, ActionSequence{}).efficiency, std::nullopt);
}

TEST(Judge, AnEmptyPlanSolvesATaskThatIsDone) {
  Task task = smallTask(1);
  task.goal = task.initial.objects[0];
  task.reference.clear();
  EXPECT_EQ(judge(task, ActionSequence{}).efficiency, 1.0);
}

TEST(Judge, TheFirstIllegalActionIsTheCause) {
  const Task task = smallTask(1);
  EXPECT_EQ(judge(task, ActionSequence{kMoveFront, kMoveLeft}).failure, Failure::kCollision);
  EXPECT_EQ(judge(task, ActionSequence{kMoveLeft, kMoveFront}).failure, Failure::kOffWorkbench);
  EXPECT_EQ(judge(task, ActionSequence{kMoveRight, kMoveRight, kChangeColor}).failure,
            Failure::kNoDyer);
  EXPECT_EQ(judge(task, ActionSequence{kMoveRight}).failure, Failure::kWrongPosition);
}

TEST(Judge, AnIllegalPlanFailsThoughItsMovesEndAtTheGoal) {
  const ActionSequence through_the_dyer{kMoveFront, kMoveRight};
  const Judgement judgement = judge(smallTask(1), through_the_dyer);
  EXPECT_EQ(judgement.failure, Failure::kCollision);
  EXPECT_EQ(judgement.final_distance, 0.0);
}

TEST(Judge, FinalDistanceFollowsMovesBeyondTheWorkbench) {
  const ActionSequence away{kMoveLeft, kMoveLeft, kMoveBack, kRotateLeft};
  EXPECT_DOUBLE_EQ(judge(smallTask(1), away).final_distance, std::hypot(3, 2));
}

TEST(Judge, WithoutAPlanTheTargetStaysWhereItIs) {
  const Judgement judgement = judge(smallTask(1), std::nullopt);
  EXPECT_EQ(judgement.failure, Failure::kNoPlan);
  EXPECT_EQ(judgement.efficiency, std::nullopt);
  EXPECT_DOUBLE_EQ(judgement.final_distance, std::sqrt(2));
}

TEST(Judge, LevelsEndAtFour) {
  EXPECT_THAT([] { judge(smallTask(5), std::nullopt); },
              testing::ThrowsMessage<std::invalid_argument>("level must be in [1, 4], not 5"));
}

TEST(Judge, FailuresHaveNames) {
  EXPECT_EQ(name(Failure::kNoPlan), "no_plan");
  EXPECT_EQ(name(Failure::kOffWorkbench), "off_workbench");
  EXPECT_EQ(name(Failure::kCollision), "collision");
  EXPECT_EQ(name(Failure::kNoDyer), "no_dyer");
  EXPECT_EQ(name(Failure::kWrongPosition), "wrong_position");
  EXPECT_EQ(name(Failure::kWrongColor), "wrong_color");
  EXPECT_EQ(name(Failure::kWrongRotation), "wrong_rotation");
}

/// The egg of the small task is to come one cell nearer and to turn to the right as well.
Task twoTargetTask(int level) {
  Task task = smallTask(level);
  task.further = {{2, {ObjectType::kEgg, {2, 0}, 3, 0, 0}}};
  task.moved = {0, 0, 0, 0, 2, 2};
  task.reference.insert(task.reference.end(), {kMoveBack, kRotateRight});
  return task;
}

TEST(Judge, EachOfSeveralTargetsMustHaveItsGoal) {
  const Task task = twoTargetTask(4);
  EXPECT_TRUE(judge(task, task.reference, task.moved).succeeded());
  EXPECT_EQ(judge(task, task.reference, task.moved).efficiency, 1.0);
  const ActionSequence unturned(task.reference.begin(), task.reference.end() - 1);
  const std::vector<std::size_t> moved(task.moved.begin(), task.moved.end() - 1);
  EXPECT_EQ(judge(task, unturned, moved).failure, Failure::kWrongRotation);
  EXPECT_TRUE(judge(twoTargetTask(3), unturned, moved).succeeded());
  const Judgement first_alone = judge(task, smallTask(4).reference);
  EXPECT_EQ(first_alone.failure, Failure::kWrongPosition);
  EXPECT_EQ(first_alone.final_distance, 1.0);
}

}  // namespace
}  // namespace conceptplan
