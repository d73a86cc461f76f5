#include "conceptplan/domain/simulation/reference_planner.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

#include "conceptplan/domain/simulation/simulator.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"

namespace conceptplan {
namespace {

using enum Action;

/// All plans of exactly that length, by enumeration.
std::set<ActionSequence> plansOfLength(const World& world, const ObjectState& goal,
                                       std::size_t length) {
  if (length == 0)
    return world.objects[world.target] == goal ? std::set<ActionSequence>{{}}
                                               : std::set<ActionSequence>{};
  std::set<ActionSequence> plans;
  for (const Action action : kActions) {
    const ActionOutcome outcome = applyAction(world, action);
    if (!outcome.succeeded()) continue;
    for (ActionSequence rest : plansOfLength(outcome.world, goal, length - 1)) {
      rest.insert(rest.begin(), action);
      plans.insert(rest);
    }
  }
  return plans;
}

TEST(ReferencePlanner, NoShorterPlanExists) {
  const TaskGenerator generator({.level = 4, .seed = 11});
  int checked = 0;
  for (int i = 0; i < 60; ++i) {
    const Task task = generator.task(i);
    if (task.reference.size() > 5) continue;
    ++checked;
    for (std::size_t length = 0; length < task.reference.size(); ++length)
      EXPECT_TRUE(plansOfLength(task.initial, task.goal, length).empty()) << task.id;
    EXPECT_TRUE(
        plansOfLength(task.initial, task.goal, task.reference.size()).contains(task.reference));
  }
  EXPECT_GT(checked, 20);
}

TEST(ReferencePlanner, DrawsUniformlyFromAllShortestPlans) {
  World world;
  world.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0}};
  ObjectState goal = world.objects[0];
  goal.cell = {1, 1};
  goal.rotation = 2;
  const std::set<ActionSequence> all = plansOfLength(world, goal, 4);
  ASSERT_EQ(all.size(), 24u);  // two turns of one kind and two moves: 2 * 4! / 2!
  std::map<ActionSequence, int> counts;
  RandomStream random{1};
  for (int i = 0; i < 2400; ++i) ++counts[shortestPlan(world, goal, random).value()];
  EXPECT_EQ(counts.size(), all.size());
  for (const auto& [plan, count] : counts) {
    EXPECT_TRUE(all.contains(plan));
    EXPECT_GT(count, 60);
    EXPECT_LT(count, 140);
  }
}

TEST(ReferencePlanner, StartEqualsGoalNeedsNoAction) {
  World world;
  world.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0}};
  RandomStream random{1};
  EXPECT_EQ(shortestPlan(world, world.objects[0], random), ActionSequence{});
}

TEST(ReferencePlanner, AWalledInTargetHasNoPlan) {
  World world;
  world.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0},
                   {ObjectType::kEgg, {1, 0}, 0, 0, 0},
                   {ObjectType::kEgg, {0, 1}, 0, 0, 0}};
  ObjectState goal = world.objects[0];
  goal.cell = {2, 2};
  RandomStream random{1};
  EXPECT_EQ(shortestPlan(world, goal, random), std::nullopt);
}

TEST(ReferencePlanner, TypeAndSizeCannotBeReached) {
  World world;
  world.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0}};
  ObjectState goal = world.objects[0];
  goal.size = 1;
  RandomStream random{1};
  EXPECT_EQ(shortestPlan(world, goal, random), std::nullopt);
  world.target = 1;
  EXPECT_THROW(shortestPlan(world, goal, random), std::invalid_argument);
}

TEST(ShortestJointPlan, IsThatOfTheTargetWhereThereIsOne) {
  const TaskGenerator generator({.level = 4, .seed = 12});
  for (int i = 0; i < 30; ++i) {
    const Task task = generator.task(i);
    EXPECT_EQ(shortestJointPlan(task)->actions.size(), task.reference.size()) << task.id;
  }
}

TEST(ShortestJointPlan, OneStepsAsideForTheOther) {
  // Two cups swap in a row with one free cell beside its middle.
  Task task;
  task.initial.workbench = {3, 2, 0.2};
  task.initial.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0},
                          {ObjectType::kCup, {2, 0}, 0, 1, 0},
                          {ObjectType::kEgg, {0, 1}, 0, 0, 0},
                          {ObjectType::kEgg, {2, 1}, 0, 0, 0}};
  task.goal = {ObjectType::kCup, {2, 0}, 0, 0, 0};
  task.further = {{1, {ObjectType::kCup, {0, 0}, 0, 1, 0}}};
  const std::optional<JointSequence> plan = shortestJointPlan(task);
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->actions.size(), 6u);
  const Replay result = replay(task.initial, plan->actions, plan->moved);
  EXPECT_TRUE(result.succeeded());
  EXPECT_EQ(result.world.objects[0], task.goal);
  EXPECT_EQ(result.world.objects[1], task.further[0].goal);
  task.initial.objects.push_back({ObjectType::kEgg, {1, 1}, 0, 0, 0});
  EXPECT_FALSE(shortestJointPlan(task).has_value());
}

}  // namespace
}  // namespace conceptplan
