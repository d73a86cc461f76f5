#include "conceptplan/domain/simulation/task_generator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "conceptplan/domain/simulation/judgement.hpp"

namespace conceptplan {
namespace {

struct Published {
  double mean;
  std::size_t lowest_max;
  std::size_t highest_max;
};

/// Lengths of the paper's tasks, Sec. II-B; the maxima of levels 3 and 4 vary with the draw.
constexpr std::array<Published, 4> kPublished{
    {{2.67, 6, 6}, {2.81, 9, 9}, {4.66, 14, 16}, {5.64, 15, 18}}};

class LevelStatistics : public testing::TestWithParam<int> {};

TEST_P(LevelStatistics, AreThoseOfThePaper) {
  const int level = GetParam();
  const TaskGenerator generator({.level = level});
  constexpr int kCount = 10000;
  double sum = 0;
  std::size_t longest = 0;
  int recolored = 0;
  std::array<int, 4> turns{};
  for (int i = 0; i < kCount; ++i) {
    const Task task = generator.task(i);
    const ObjectState& start = task.initial.objects[task.initial.target];
    sum += static_cast<double>(task.reference.size());
    longest = std::max(longest, task.reference.size());
    recolored += task.goal.color != start.color;
    ++turns[static_cast<std::size_t>((task.goal.rotation - start.rotation + 4) % 4)];
  }
  const Published& published = kPublished[static_cast<std::size_t>(level - 1)];
  EXPECT_NEAR(sum / kCount, published.mean, 0.08);
  EXPECT_GE(longest, published.lowest_max);
  EXPECT_LE(longest, published.highest_max);
  EXPECT_NEAR(recolored, level >= 3 ? 7500 : 0, 200);
  if (level < 4) {
    EXPECT_EQ(turns[0], kCount);
  } else {
    for (const int count : turns) EXPECT_NEAR(count, 2500, 200);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, LevelStatistics, testing::Values(1, 2, 3, 4));

TEST(TaskGenerator, EveryTaskIsWellFormedAndSolved) {
  for (int level = 1; level <= 4; ++level) {
    const TaskGenerator generator({.level = level, .split = Split::kTest, .seed = 5});
    for (int i = 0; i < 500; ++i) {
      const Task task = generator.task(i);
      const ObjectState& start = task.initial.objects.at(task.initial.target);
      std::set<Cell> cells;
      int dyers = 0;
      for (const ObjectState& object : task.initial.objects) {
        EXPECT_TRUE(task.initial.workbench.contains(object.cell));
        EXPECT_TRUE(cells.insert(object.cell).second) << "two objects in one cell";
        EXPECT_LT(static_cast<std::size_t>(object.type), kNumSeenTypes);
        dyers += object.type == ObjectType::kDyer;
      }
      EXPECT_EQ(task.initial.objects.size(), level == 1 ? 1u : level == 2 ? 3u : 4u);
      EXPECT_EQ(dyers, level >= 3 ? 1 : 0);
      EXPECT_NE(start.type, ObjectType::kDyer);
      EXPECT_FALSE(cells.contains(task.goal.cell));
      EXPECT_EQ(task.goal.type, start.type);
      EXPECT_EQ(task.goal.size, start.size);
      EXPECT_FALSE(task.reference.empty());
      EXPECT_TRUE(judge(task, task.reference).succeeded()) << task.id;
    }
  }
}

TEST(TaskGenerator, EachTaskHasAStreamOfItsOwn) {
  const TaskGenerator generator({.level = 3, .seed = 4});
  const Task late = generator.task(17);
  generator.task(0);
  const Task again = TaskGenerator({.level = 3, .seed = 4}).task(17);
  EXPECT_EQ(late.id, "level3-000017");
  EXPECT_EQ(late.initial, again.initial);
  EXPECT_EQ(late.goal, again.goal);
  EXPECT_EQ(late.reference, again.reference);
  EXPECT_EQ(late.appearance, again.appearance);
  EXPECT_NE(late.appearance, generator.task(18).appearance);
  EXPECT_NE(late.appearance, TaskGenerator({.level = 3, .seed = 5}).task(17).appearance);
}

TEST(TaskGenerator, SplitsShareNoArrangementAndNoAppearance) {
  constexpr std::array<Split, 3> kSplits{Split::kTrain, Split::kValidation, Split::kTest};
  for (const int level : {1, 4}) {
    std::array<std::set<std::pair<ObjectState, ObjectState>>, 3> tasks;
    for (const Split split : kSplits) {
      const TaskGenerator generator({.level = level, .split = split, .seed = 0});
      for (int i = 0; i < 3000; ++i) {
        const Task task = generator.task(i);
        EXPECT_EQ(splitOf(task.initial, task.goal), split);
        EXPECT_EQ(task.appearance >> 62, static_cast<std::uint64_t>(split) + 1);
        if (level == 1)
          tasks[static_cast<std::size_t>(split)].insert({task.initial.objects[0], task.goal});
      }
    }
    for (const auto& task : tasks[0]) {
      EXPECT_FALSE(tasks[1].contains(task));
      EXPECT_FALSE(tasks[2].contains(task));
    }
  }
}

TEST(TaskGenerator, TheOrderOfObjectsDoesNotDecideTheSplit) {
  const TaskGenerator generator({.level = 4});
  for (int i = 0; i < 100; ++i) {
    Task task = generator.task(i);
    std::reverse(task.initial.objects.begin(), task.initial.objects.end());
    task.initial.target = task.initial.objects.size() - 1 - task.initial.target;
    EXPECT_EQ(splitOf(task.initial, task.goal), Split::kTrain);
  }
}

TEST(TaskGenerator, UnseenObjectsAreOfTheFourUnseenTypes) {
  const TaskGenerator generator({.level = 3, .objects = ObjectSet::kUnseen});
  std::set<ObjectType> types;
  for (int i = 0; i < 200; ++i)
    for (const ObjectState& object : generator.task(i).initial.objects) types.insert(object.type);
  EXPECT_THAT(types, testing::ElementsAre(ObjectType::kDyer, ObjectType::kCellphone,
                                          ObjectType::kDishSponge, ObjectType::kSaltshaker,
                                          ObjectType::kPotato));
}

TEST(TaskGenerator, UnseenTasksUseOtherActionTypesThanTrainingTasks) {
  using Types = std::set<Action>;
  std::array<std::set<Types>, 3> types;
  for (const int level : {1, 2}) {
    for (const Split split : {Split::kTrain, Split::kValidation, Split::kTest}) {
      const TaskGenerator generator(
          {.level = level, .split = split, .combination = Combination::kUnseenTask});
      for (int i = 0; i < 1000; ++i) {
        const ActionSequence plan = generator.task(i).reference;
        types[static_cast<std::size_t>(split)].insert({plan.begin(), plan.end()});
      }
    }
  }
  for (const Types& held_out : types[1]) EXPECT_FALSE(types[0].contains(held_out));
  for (const Types& held_out : types[2]) EXPECT_FALSE(types[0].contains(held_out));
  Types trained;
  for (const Types& set : types[0]) trained.insert(set.begin(), set.end());
  EXPECT_EQ(trained.size(), 4u) << "every move must occur in training";
}

TEST(TaskGenerator, NoTrainingPlanOfAnyLevelIsHeldOutUnderUnseenTask) {
  for (int level = 1; level <= 4; ++level) {
    const TaskGenerator generator({.level = level, .combination = Combination::kUnseenTask});
    std::set<Action> trained;
    for (int i = 0; i < 1000; ++i) {
      const Task task = generator.task(i);
      EXPECT_FALSE(isHeldOut(task.reference)) << task.id;
      EXPECT_EQ(splitOf(task.initial, task.goal), Split::kTrain);
      trained.insert(task.reference.begin(), task.reference.end());
    }
    EXPECT_EQ(trained.size(), level < 3    ? 4u
                              : level == 3 ? 5u
                                           : 7u)
        << "every action of the level must occur in training";
    EXPECT_EQ(generator.task(17).reference, TaskGenerator(generator.options()).task(17).reference);
  }
}

TEST(TaskGenerator, HeldOutSetsAreThoseOfTwoListedPairs) {
  using enum Action;
  EXPECT_FALSE(isHeldOut({}));
  EXPECT_FALSE(isHeldOut({kMoveFront, kMoveLeft}));
  EXPECT_FALSE(isHeldOut({kMoveRight, kMoveBack, kMoveRight}));
  EXPECT_TRUE(isHeldOut({kMoveFront, kMoveRight}));
  EXPECT_TRUE(isHeldOut({kMoveLeft, kMoveLeft, kMoveBack}));
  EXPECT_TRUE(isHeldOut({kMoveFront, kMoveLeft, kMoveBack}));
}

TEST(TaskGenerator, WrongOptionsAreNamed) {
  EXPECT_THAT([] { TaskGenerator({.level = 5}); },
              testing::ThrowsMessage<std::invalid_argument>("level must be in [1, 4], not 5"));
  const TaskOptions unseen{
      .level = 3, .split = Split::kTest, .combination = Combination::kUnseenTask};
  EXPECT_THAT([&] { TaskGenerator{unseen}; },
              testing::ThrowsMessage<std::invalid_argument>(
                  "unseen-task combinations of the test split exist at levels 1 and 2 only, not "
                  "at level 3"));
  EXPECT_THROW(TaskGenerator(TaskOptions{}).task(-1), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
