#include <gtest/gtest.h>

#include <algorithm>

#include "report_outline.hpp"

namespace conceptplan::report {
namespace {

RgbdImage masked(int width, std::vector<std::uint8_t> mask) {
  const int height = static_cast<int>(mask.size()) / width;
  return {width, height, {}, {}, std::move(mask)};
}

std::ptrdiff_t parts(const std::string& path) { return std::count(path.begin(), path.end(), 'Z'); }

TEST(Outline, OfAPixelIsADiamondThroughTheMiddlesOfItsEdges) {
  const auto all = outlines(masked(3, {0, 0, 0, 0, 5, 0, 0, 0, 0}));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].instance, 5);
  EXPECT_EQ(all[0].path, "M1.5 1.0L2.0 1.5L1.5 2.0L1.0 1.5Z");
  EXPECT_EQ(all[0].center_x, 1.5);
  EXPECT_EQ(all[0].top, 1);
}

TEST(Outline, KeepsInstancesApart) {
  const auto all = outlines(masked(2, {2, 1}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].instance, 1);
  EXPECT_EQ(all[1].instance, 2);
}

TEST(Outline, GoesAroundEveryPartAndHole) {
  EXPECT_EQ(parts(outlines(masked(3, {1, 0, 1}))[0].path), 2);
  EXPECT_EQ(parts(outlines(masked(3, {1, 1, 1, 1, 0, 1, 1, 1, 1}))[0].path), 2);
}

TEST(Outline, ClosesWherePartsTouchAtACorner) {
  const std::string path = outlines(masked(2, {1, 0, 0, 1}))[0].path;
  EXPECT_EQ(parts(path), std::count(path.begin(), path.end(), 'M'));
}

TEST(Outline, LeavesOutPointsOnAStraightLine) {
  const std::string path = outlines(masked(9, {1, 1, 1, 1, 1, 1, 1, 1, 1}))[0].path;
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 5);
}

TEST(Outline, OfNothingIsNothing) { EXPECT_TRUE(outlines(masked(2, {0, 0})).empty()); }

}  // namespace
}  // namespace conceptplan::report
