#include "conceptplan/domain/rendering/contact_sheet.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace conceptplan {
namespace {

TEST(ContactSheet, ShowsEveryTypeInEveryRotation) {
  Renderer renderer;
  const Picture sheet = rotationSheet(renderer, {.appearance = {3}, .scale = 1});
  EXPECT_EQ(sheet.width, 110 + 4 * 64);
  EXPECT_EQ(sheet.height, 24 + 12 * 64);
  ASSERT_EQ(sheet.rgb.size(), 3U * static_cast<unsigned>(sheet.width * sheet.height));
}

TEST(ContactSheet, ShowsColorsAndSizesAtAnyScale) {
  Renderer renderer;
  const Picture sheet =
      colorAndSizeSheet(renderer, ObjectType::kCup, {.appearance = {}, .scale = 3});
  EXPECT_EQ(sheet.width, 110 + 4 * 192);
  EXPECT_EQ(sheet.height, 24 + 6 * 192);
  // The middle of each row's largest cup is of the row's colour: six different ones.
  std::set<std::array<std::uint8_t, 3>> colors;
  for (int row = 0; row < 6; ++row) {
    const std::size_t i =
        3 * static_cast<std::size_t>((24 + row * 192 + 125) * sheet.width + 110 + 3 * 192 + 70);
    colors.insert({sheet.rgb[i], sheet.rgb[i + 1], sheet.rgb[i + 2]});
  }
  EXPECT_EQ(colors.size(), 6U);
}

TEST(ContactSheet, RejectsAScaleOutOfRange) {
  Renderer renderer;
  EXPECT_THROW(rotationSheet(renderer, {.appearance = {}, .scale = 0}), std::invalid_argument);
  EXPECT_THROW(colorAndSizeSheet(renderer, ObjectType::kEgg, {.appearance = {}, .scale = 9}),
               std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
