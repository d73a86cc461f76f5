#include "conceptplan/domain/simulation/simulator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"

namespace conceptplan {
namespace {

using enum Action;

/// A cup at (1, 2), an egg at (0, 2) and a blue dyer at (2, 4).
World smallWorld() {
  World world;
  world.objects = {{ObjectType::kEgg, {0, 2}, 0, 1, 2},
                   {ObjectType::kCup, {1, 2}, 3, 0, 1},
                   {ObjectType::kDyer, {2, 4}, 1, 4, 3}};
  world.target = 1;
  return world;
}

Cell cellAfterMove(const World& world, Action action) {
  return applyAction(world, action).world.objects[world.target].cell;
}

TEST(Simulator, FrontIsPlusYAndRightIsPlusX) {
  World world = smallWorld();
  world.objects[0].cell = {0, 0};
  EXPECT_EQ(cellAfterMove(world, kMoveFront), (Cell{1, 3}));
  EXPECT_EQ(cellAfterMove(world, kMoveBack), (Cell{1, 1}));
  EXPECT_EQ(cellAfterMove(world, kMoveLeft), (Cell{0, 2}));
  EXPECT_EQ(cellAfterMove(world, kMoveRight), (Cell{2, 2}));
}

TEST(Simulator, AMoveChangesNothingElse) {
  const World before = smallWorld();
  World expected = before;
  expected.objects[1].cell = {1, 3};
  EXPECT_EQ(applyAction(before, kMoveFront).world, expected);
}

TEST(Simulator, LeftTurnsAddAQuarter) {
  const World world = smallWorld();
  EXPECT_EQ(applyAction(world, kRotateLeft).world.objects[1].rotation, 0);
  EXPECT_EQ(applyAction(world, kRotateRight).world.objects[1].rotation, 2);
}

TEST(Simulator, FourTurnsAndOppositeActionsUndoEachOther) {
  const World world = smallWorld();
  for (const ActionSequence& loop :
       {ActionSequence{kRotateLeft, kRotateLeft, kRotateLeft, kRotateLeft},
        ActionSequence{kRotateLeft, kRotateRight}, ActionSequence{kMoveFront, kMoveBack},
        ActionSequence{kMoveRight, kMoveLeft}, ActionSequence{}}) {
    const Replay result = replay(world, loop);
    EXPECT_TRUE(result.succeeded());
    EXPECT_EQ(result.world, world);
  }
}

TEST(Simulator, AnyObjectBlocksItsCell) {
  const ActionOutcome egg = applyAction(smallWorld(), kMoveLeft);
  EXPECT_EQ(egg.obstruction, Obstruction::kCollision);
  EXPECT_EQ(egg.obstacle, 0u);
  EXPECT_EQ(egg.world, smallWorld());

  World beside_dyer = smallWorld();
  beside_dyer.objects[1].cell = {2, 3};
  const ActionOutcome dyer = applyAction(beside_dyer, kMoveFront);
  EXPECT_EQ(dyer.obstruction, Obstruction::kCollision);
  EXPECT_EQ(dyer.obstacle, 2u);
}

TEST(Simulator, TheWorkbenchEndsAtItsCells) {
  World world = smallWorld();
  world.objects[1].cell = {0, 0};
  EXPECT_EQ(applyAction(world, kMoveLeft).obstruction, Obstruction::kOffWorkbench);
  EXPECT_EQ(applyAction(world, kMoveBack).obstruction, Obstruction::kOffWorkbench);
  world.objects[1].cell = {2, 0};
  EXPECT_EQ(applyAction(world, kMoveRight).obstruction, Obstruction::kOffWorkbench);
  world.objects[1].cell = {0, 4};
  EXPECT_EQ(applyAction(world, kMoveFront).obstruction, Obstruction::kOffWorkbench);
}

TEST(Simulator, OnlyTheFourNeighboursOfADyerAreBesideIt) {
  World world = smallWorld();
  world.objects[0].cell = {0, 0};
  world.objects[2].cell = {1, 2};
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 5; ++y) {
      if (Cell{x, y} == world.objects[2].cell) continue;
      world.objects[1].cell = {x, y};
      const ActionOutcome outcome = applyAction(world, kChangeColor);
      const bool beside = (x == 1 && (y == 1 || y == 3)) || (y == 2 && (x == 0 || x == 2));
      EXPECT_EQ(outcome.succeeded(), beside) << x << ", " << y;
      EXPECT_EQ(outcome.world.objects[1].color, beside ? 4 : 0);
      EXPECT_EQ(outcome.obstruction == Obstruction::kNoDyer, !beside);
    }
  }
}

TEST(Simulator, TheDyerItselfIsNotBesideADyer) {
  World world = smallWorld();
  world.target = 2;
  EXPECT_EQ(applyAction(world, kChangeColor).obstruction, Obstruction::kNoDyer);
}

TEST(Simulator, OfTwoDyersTheFirstColours) {
  World world = smallWorld();
  world.objects[0] = {ObjectType::kDyer, {0, 2}, 0, 3, 0};
  world.objects[2].cell = {1, 3};
  EXPECT_EQ(applyAction(world, kChangeColor).world.objects[1].color, 3);
}

TEST(Simulator, ReplayStopsBeforeTheFirstIllegalAction) {
  const Replay result = replay(smallWorld(), {kMoveFront, kMoveFront, kMoveFront, kMoveLeft});
  EXPECT_EQ(result.obstruction, Obstruction::kOffWorkbench);
  EXPECT_EQ(result.steps, 2u);
  EXPECT_EQ(result.world.objects[1].cell, (Cell{1, 4}));
}

TEST(Simulator, ReplayOfAConcatenationIsTheReplayOfBothParts) {
  for (int i = 0; i < 200; ++i) {
    const Task task = TaskGenerator({.level = 4, .seed = 3}).task(i);
    const auto middle =
        task.reference.begin() + static_cast<std::ptrdiff_t>(task.reference.size() / 2);
    const World half = replay(task.initial, {task.reference.begin(), middle}).world;
    EXPECT_EQ(replay(half, {middle, task.reference.end()}).world,
              replay(task.initial, task.reference).world);
  }
}

TEST(Simulator, AdvanceIsApplyActionInPlace) {
  RandomStream random{5};
  for (int i = 0; i < 200; ++i) {
    World world = TaskGenerator({.level = 3, .seed = 3}).task(i).initial;
    const Action action = kActions[random.below(kNumActions)];
    const ActionOutcome outcome = applyAction(world, action);
    EXPECT_EQ(advance(world, action), outcome.obstruction);
    EXPECT_EQ(world, outcome.world);
  }
}

TEST(Simulator, AMissingTargetIsABrokenPrecondition) {
  World world = smallWorld();
  world.target = 3;
  EXPECT_THAT([&] { applyAction(world, kMoveFront); },
              testing::ThrowsMessage<std::invalid_argument>("target 3 of a world of 3 objects"));
  EXPECT_THROW(replay(world, {}), std::invalid_argument);
}

TEST(Simulator, ObstructionsHaveTheNamesOfFailures) {
  EXPECT_EQ(name(Obstruction::kOffWorkbench), "off_workbench");
  EXPECT_EQ(name(Obstruction::kCollision), "collision");
  EXPECT_EQ(name(Obstruction::kNoDyer), "no_dyer");
}

TEST(Replay, MovesTheObjectThatIsNamed) {
  // The egg makes way for the cup.
  const std::vector<std::size_t> moved{0, 1, 1};
  const Replay result = replay(smallWorld(), {kMoveBack, kMoveLeft, kRotateLeft}, moved);
  EXPECT_TRUE(result.succeeded());
  EXPECT_EQ(result.world.objects[0].cell, (Cell{0, 1}));
  EXPECT_EQ(result.world.objects[1].cell, (Cell{0, 2}));
  EXPECT_EQ(result.world.objects[1].rotation, 0);
  EXPECT_EQ(replay(smallWorld(), {kMoveLeft}, std::vector<std::size_t>{1}).obstacle, 0u);
  EXPECT_THROW(replay(smallWorld(), {kMoveLeft}, moved), std::invalid_argument);
  EXPECT_THROW(replay(smallWorld(), {kMoveLeft}, std::vector<std::size_t>{3}),
               std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
