#include "legality_trace.hpp"

#include <gmock/gmock.h>

#include "conceptplan/planners/planner_registry.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::learnedModel;
using testing::learnedRelabelling;

PlanResult solve(const Task& task, const char* planner, std::size_t horizon = 24) {
  PlanQuery query;
  query.limits.horizon = horizon;
  return PlannerRegistry::standard().make(planner)->solve(
      compile(learnedModel(), learnedRelabelling().problem(task), GridValidity()), query);
}

/// A cup in a corner behind a pot and an egg; a plate stands apart.
Task lockedInTask() {
  Task task;
  task.initial.objects = {{ObjectType::kPlate, {2, 2}, 0, 0, 0},
                          {ObjectType::kPot, {1, 0}, 0, 0, 0},
                          {ObjectType::kCup, {0, 0}, 0, 0, 0},
                          {ObjectType::kEgg, {0, 1}, 0, 0, 0}};
  task.initial.target = 2;
  task.goal = task.initial.objects[2];
  task.goal.cell = {2, 4};
  task.goal.rotation = 1;
  return task;
}

class InfeasibleTrace : public ::testing::TestWithParam<const char*> {};

TEST_P(InfeasibleTrace, NamesTheFewestObjectsWithoutWhichThereIsAWay) {
  const PlanResult result = solve(lockedInTask(), GetParam());
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  // Without the pot alone, or the egg alone, the cup gets out; the pot comes first.
  EXPECT_THAT(result.blocking, ElementsAre(1));
  EXPECT_THAT(result.reason, HasSubstr("without object 1 there would be a way"));
}

TEST_P(InfeasibleTrace, NamesSeveralObjectsWhereOneIsNotEnough) {
  Task task = lockedInTask();
  task.initial.objects[0].cell = {1, 4};
  task.initial.objects.push_back({ObjectType::kBread, {2, 3}, 0, 0, 0});
  const PlanResult result = solve(task, GetParam());
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  // The plate and the pan shut the goal in, the pot and the egg the cup: one of each must go.
  EXPECT_THAT(result.blocking, ElementsAre(0, 1));
  EXPECT_THAT(result.reason, HasSubstr("without objects 0 and 1 there would be a way"));
}

TEST_P(InfeasibleTrace, TellsHowNearTheTargetGets) {
  const Task task = lockedInTask();
  const PlanResult result = solve(task, GetParam());
  ObjectState turned = task.initial.objects[2];
  turned.rotation = task.goal.rotation;
  ASSERT_TRUE(result.nearest.has_value());
  EXPECT_EQ(*result.nearest, learnedRelabelling().symbols(turned));
  EXPECT_THAT(result.reason,
              HasSubstr("differs from the goal at least in POSITION_X and POSITION_Y"));
}

TEST_P(InfeasibleTrace, AnObjectInTheGoalsCellIsTheReason) {
  Task task = lockedInTask();
  task.initial.objects = {task.initial.objects[2], {ObjectType::kPot, task.goal.cell, 0, 0, 0}};
  task.initial.target = 0;
  EXPECT_THAT(solve(task, GetParam()).blocking, ElementsAre(1));
}

TEST_P(InfeasibleTrace, AHorizonTooShortIsNoObjectsFault) {
  Task task = lockedInTask();
  task.initial.objects = {task.initial.objects[2]};
  task.initial.target = 0;
  const PlanResult result = solve(task, GetParam(), 3);
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_THAT(result.reason, HasSubstr("within 3 actions; it takes at least 7"));
}

TEST_P(InfeasibleTrace, APlanHasNoSuchReason) {
  Task task = lockedInTask();
  task.initial.objects[1].cell = {1, 1};
  const PlanResult result = solve(task, GetParam());
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_FALSE(result.nearest.has_value());
}

INSTANTIATE_TEST_SUITE_P(Planners, InfeasibleTrace,
                         ::testing::Values("belief", "astar", "value-iteration"),
                         [](const auto& planner) {
                           std::string name = planner.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace conceptplan
