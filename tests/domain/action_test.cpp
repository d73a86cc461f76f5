#include "conceptplan/domain/action.hpp"

#include <gtest/gtest.h>

#include <set>

namespace conceptplan {
namespace {

TEST(Action, NamesAndActionsAreOneToOne) {
  std::set<std::string_view> names;
  for (const Action action : kActions) {
    EXPECT_EQ(actionNamed(name(action)), action);
    names.insert(name(action));
  }
  EXPECT_EQ(names.size(), kNumActions);
  EXPECT_EQ(actionNames().size(), kNumActions);
  EXPECT_EQ(actionNames().at(index(Action::kMoveLeft)), name(Action::kMoveLeft));
}

TEST(Action, NamesAreThoseOfResultFiles) {
  EXPECT_EQ(name(Action::kMoveFront), "move_front");
  EXPECT_EQ(name(Action::kMoveBack), "move_back");
  EXPECT_EQ(name(Action::kMoveLeft), "move_left");
  EXPECT_EQ(name(Action::kMoveRight), "move_right");
  EXPECT_EQ(name(Action::kRotateLeft), "rotate_left");
  EXPECT_EQ(name(Action::kRotateRight), "rotate_right");
  EXPECT_EQ(name(Action::kChangeColor), "change_color");
}

TEST(Action, OtherNamesAreNone) {
  EXPECT_EQ(actionNamed("move"), std::nullopt);
  EXPECT_EQ(actionNamed(""), std::nullopt);
  EXPECT_EQ(actionNamed("Move_Front"), std::nullopt);
}

}  // namespace
}  // namespace conceptplan
