#include <gtest/gtest.h>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

ActionDescription descriptionOf(Action action) {
  SymbolicModel model = testing::tinyModel();
  model.grounding.names[index(Concept::kType)] = {"Cup", "Dyer"};
  return describe(model)[index(action)];
}

TEST(ModelDescription, TellsContextsInWhichAnActionIsNeverTaken) {
  EXPECT_EQ(descriptionOf(Action::kMoveRight).needs, "own POSITION_X is not POSITION_X 2");
  EXPECT_EQ(descriptionOf(Action::kRotateLeft).needs, "nothing");
}

TEST(ModelDescription, TellsChangesOfTheOwnSymbol) {
  EXPECT_EQ(descriptionOf(Action::kMoveLeft).does,
            "POSITION_X: POSITION_X 1 -> POSITION_X 0, POSITION_X 2 -> POSITION_X 1");
  EXPECT_EQ(descriptionOf(Action::kMoveBack).does, "nothing");
}

TEST(ModelDescription, TellsSymbolsTakenFromAnotherObject) {
  const ActionDescription description = descriptionOf(Action::kChangeColor);
  EXPECT_EQ(description.needs, "a Dyer on the workbench");
  EXPECT_EQ(description.does, "COLOR becomes that of the nearest Dyer");
}

TEST(ModelDescription, GivesTheMeanProbabilityOfTheMostProbableEffect) {
  EXPECT_DOUBLE_EQ(descriptionOf(Action::kMoveLeft).probability, 1);
  EXPECT_DOUBLE_EQ(descriptionOf(Action::kRotateLeft).probability, 0.9);
}

}  // namespace
}  // namespace conceptplan
