#include "conceptplan/domain/task.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

TEST(Task, OptionsAndTheirNamesAreOneToOne) {
  for (const Split split : {Split::kTrain, Split::kValidation, Split::kTest})
    EXPECT_EQ(splitNamed(name(split)), split);
  for (const ObjectSet objects : {ObjectSet::kSeen, ObjectSet::kUnseen})
    EXPECT_EQ(objectSetNamed(name(objects)), objects);
  for (const Combination combination : {Combination::kAll, Combination::kUnseenTask})
    EXPECT_EQ(combinationNamed(name(combination)), combination);
  for (const RenderDomain domain : {RenderDomain::kStandard, RenderDomain::kShifted})
    EXPECT_EQ(renderDomainNamed(name(domain)), domain);
}

TEST(Task, ListsItsTargetsTheFirstOneFirst) {
  Task task;
  task.initial.target = 2;
  task.goal.size = 3;
  task.further = {{0, {}}};
  const std::vector<FurtherTarget> targets = targetsOf(task);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].object, 2U);
  EXPECT_EQ(targets[0].goal, task.goal);
  EXPECT_EQ(targets[1].object, 0U);
}

TEST(Task, NamesAreThoseOfTheCommandLine) {
  EXPECT_EQ(splitNamed("validation"), Split::kValidation);
  EXPECT_EQ(objectSetNamed("unseen"), ObjectSet::kUnseen);
  EXPECT_EQ(combinationNamed("unseen-task"), Combination::kUnseenTask);
  EXPECT_EQ(renderDomainNamed("shifted"), RenderDomain::kShifted);
  EXPECT_EQ(splitNamed("Train"), std::nullopt);
  EXPECT_EQ(combinationNamed("unseen"), std::nullopt);
}

}  // namespace
}  // namespace conceptplan
