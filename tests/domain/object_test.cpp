#include "conceptplan/domain/object.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace conceptplan {
namespace {

TEST(ObjectType, NamesAndTypesAreOneToOne) {
  for (std::size_t i = 0; i < kNumObjectTypes; ++i) {
    const auto type = static_cast<ObjectType>(i);
    EXPECT_EQ(objectTypeNamed(name(type)), type);
  }
  EXPECT_EQ(objectTypeNamed("bread"), std::nullopt);
  EXPECT_EQ(name(ObjectType::kDishSponge), "DishSponge");
}

TEST(ObjectType, TheDyerIsTheLastSeenType) {
  EXPECT_EQ(static_cast<std::size_t>(ObjectType::kDyer), kNumSeenTypes - 1);
}

TEST(Color, NamesAreInOrder) {
  EXPECT_EQ(colorName(0), "red");
  EXPECT_EQ(colorName(5), "magenta");
  EXPECT_THAT([] { colorName(6); },
              testing::ThrowsMessage<std::invalid_argument>("color must be in [0, 6), not 6"));
  EXPECT_THROW(colorName(-1), std::invalid_argument);
}

TEST(Size, ScalesGrowToOne) {
  for (int size = 1; size < 4; ++size) EXPECT_GT(sizeScale(size), sizeScale(size - 1));
  EXPECT_DOUBLE_EQ(sizeScale(0), 0.55);
  EXPECT_DOUBLE_EQ(sizeScale(3), 1.0);
  EXPECT_THAT([] { sizeScale(4); },
              testing::ThrowsMessage<std::invalid_argument>("size must be in [0, 4), not 4"));
}

}  // namespace
}  // namespace conceptplan
