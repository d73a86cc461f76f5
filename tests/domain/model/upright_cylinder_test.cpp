#include "conceptplan/domain/model/upright_cylinder.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace conceptplan {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Symbols at(int x, int y, int size = 3) {
  return {SymbolId{0}, SymbolId{x}, SymbolId{y}, SymbolId{0}, SymbolId{0}, SymbolId{size}};
}

TEST(UprightCylinder, StandsInTheMiddleOfItsCellWithItsFootprint) {
  const UprightCylinder cylinder = cylinderOf({}, standardGrounding(), at(0, 4, 0));
  EXPECT_TRUE(cylinder.p_WCentre.isApprox(Eigen::Vector2d(-0.2, 0.4)));
  EXPECT_DOUBLE_EQ(cylinder.radius_m, 0.08 * 0.55);
  EXPECT_DOUBLE_EQ(cylinder.height_m, 0.16 * 0.55);
}

TEST(UprightCylinder, ItsRadiusCountsUpToAShareOfTheCell) {
  EXPECT_DOUBLE_EQ(cylinderOf({}, standardGrounding(), at(0, 4), 0.3).radius_m, 0.06);
}

TEST(UprightCylinder, IsMeasuredWhereAllIsFiniteAndPositive) {
  EXPECT_TRUE((UprightCylinder{{0, 0}, 0.1, 0.2}).measured());
  EXPECT_FALSE((UprightCylinder{{0, kNan}, 0.1, 0.2}).measured());
  EXPECT_FALSE((UprightCylinder{{0, 0}, 0, 0.2}).measured());
  EXPECT_FALSE((UprightCylinder{{0, 0}, kNan, 0.2}).measured());
  EXPECT_FALSE((UprightCylinder{{0, 0}, 0.1, -1}).measured());
}

TEST(UprightCylinder, ClearanceIsThatOfTheDiscs) {
  EXPECT_NEAR(clearance_m({{0, 0}, 0.1, 1}, {{0.3, 0.4}, 0.2, 1}), 0.2, 1e-12);
  EXPECT_NEAR(clearance_m({{0, 0}, 0.1, 1}, {{0.1, 0}, 0.2, 1}), -0.2, 1e-12);
}

TEST(UprightCylinder, ClearanceAlongAMotionIsTheLeastOnTheWay) {
  const UprightCylinder moved{{-1, 0}, 0.1, 1};
  EXPECT_NEAR(clearanceAlong_m(moved, {1, 0}, {{0.2, 0.5}, 0.2, 1}), 0.2, 1e-12);  // beside it
  EXPECT_NEAR(clearanceAlong_m(moved, {1, 0}, {{-2, 0}, 0.2, 1}), 0.7, 1e-12);     // at its start
  EXPECT_NEAR(clearanceAlong_m(moved, {1, 0}, {{1.5, 0}, 0.2, 1}), 0.2, 1e-12);    // at its end
  EXPECT_NEAR(clearanceAlong_m(moved, {-1, 0}, {{0, 0}, 0.2, 1}), 0.7, 1e-12);     // at rest
}

TEST(UprightCylinder, ClearanceToTheEdgeIsThatToTheNearest) {
  EXPECT_NEAR(edgeClearance_m({}, {{0.2, 0}, 0.07, 1}), 0.03, 1e-12);
  EXPECT_NEAR(edgeClearance_m({}, {{0, -0.45}, 0.07, 1}), -0.02, 1e-12);
}

}  // namespace
}  // namespace conceptplan
