#include "conceptplan/domain/model/upright_prism.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace conceptplan {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Symbols at(int x, int y, int size = 3) {
  return {SymbolId{0}, SymbolId{x}, SymbolId{y}, SymbolId{0}, SymbolId{0}, SymbolId{size}};
}

TEST(UprightPrism, StandsInTheMiddleOfItsCellWithItsFootprint) {
  const UprightPrism prism = prismOf({}, standardGrounding(), at(0, 4, 0));
  EXPECT_TRUE(prism.p_WCentre.isApprox(Eigen::Vector2d(-0.2, 0.4)));
  EXPECT_EQ(prism.outline, outlineOfDisc(0.08 * 0.55));
  EXPECT_DOUBLE_EQ(prism.height_m, 0.16 * 0.55);
}

TEST(UprightPrism, HasTheFootprintOfItsRotation) {
  SymbolGrounding grounding = standardGrounding();
  grounding.footprints[0][3][1] = {outlineOfSquare(0.07), 0.1};
  Symbols turned = at(0, 0);
  turned[index(Concept::kRotation)] = SymbolId{1};
  EXPECT_EQ(prismOf({}, grounding, turned).outline, outlineOfSquare(0.07));
  EXPECT_EQ(prismOf({}, grounding, at(0, 0)).outline, outlineOfDisc(0.08));
}

TEST(UprightPrism, ItsOutlineCountsUpToAShareOfTheCell) {
  EXPECT_DOUBLE_EQ(prismOf({}, standardGrounding(), at(0, 4), 0.3).outline.support_m[0], 0.06);
}

TEST(UprightPrism, IsMeasuredWhereAllIsFiniteAndPositive) {
  const Outline sound = outlineOfDisc(0.1);
  Outline broken = sound;
  broken.support_m[5] = kNan;
  EXPECT_TRUE((UprightPrism{{0, 0}, sound, 0.2}).measured());
  EXPECT_FALSE((UprightPrism{{0, kNan}, sound, 0.2}).measured());
  EXPECT_FALSE((UprightPrism{{0, 0}, outlineOfDisc(0), 0.2}).measured());
  EXPECT_FALSE((UprightPrism{{0, 0}, broken, 0.2}).measured());
  EXPECT_FALSE((UprightPrism{{0, 0}, sound, -1}).measured());
}

TEST(UprightPrism, ClearanceIsTheDistanceSeenFromAbove) {
  const Outline small = outlineOfSquare(0.1), large = outlineOfDisc(0.2);
  EXPECT_NEAR(clearance_m({{0, 0}, small, 1}, {{0.5, 0}, large, 1}), 0.2, 1e-12);
  EXPECT_NEAR(clearance_m({{0, 0}, small, 1}, {{0.1, 0}, large, 1}), -0.2, 1e-12);
  // Corner to corner: Euclid's distance along one of the directions, a little less between two.
  EXPECT_NEAR(clearance_m({{0, 0}, small, 1}, {{0.4, 0.4}, small, 1}), std::hypot(0.2, 0.2), 1e-12);
  const double between = std::hypot(0.2, 0.3);
  const double found = clearance_m({{0, 0}, small, 1}, {{0.4, 0.5}, small, 1});
  EXPECT_LE(found, between);
  EXPECT_GE(found, 0.98 * between);
}

TEST(UprightPrism, ClearanceAlongAMotionIsTheLeastOnTheWay) {
  std::mt19937_64 random(1);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const auto prism = [&] {
    Outline outline;
    for (double& support_m : outline.support_m) support_m = draw(0.05, 0.2);
    return UprightPrism{{draw(-1, 1), draw(-1, 1)}, tightened(outline), 1};
  };
  for (int i = 0; i < 300; ++i) {
    UprightPrism moved = prism();
    const UprightPrism other = prism();
    const Eigen::Vector2d p_WFrom = moved.p_WCentre, p_WTo(draw(-1, 1), draw(-1, 1));
    const double found = clearanceAlong_m(moved, p_WTo, other);
    double least = clearance_m(moved, other);
    for (int step = 0; step <= 1000; ++step) {
      moved.p_WCentre = p_WFrom + step / 1000.0 * (p_WTo - p_WFrom);
      least = std::min(least, clearance_m(moved, other));
    }
    EXPECT_LE(found, least + 1e-12);
    EXPECT_GE(found, least - (p_WTo - p_WFrom).norm() / 1000);
  }
  const UprightPrism resting{{-1, 0}, outlineOfDisc(0.1), 1};
  EXPECT_NEAR(clearanceAlong_m(resting, {-1, 0}, {{0, 0}, outlineOfDisc(0.2), 1}), 0.7, 1e-12);
}

TEST(UprightPrism, ClearanceToTheEdgeIsThatToTheNearest) {
  EXPECT_NEAR(edgeClearance_m({}, {{0.2, 0}, outlineOfDisc(0.07), 1}), 0.03, 1e-12);
  EXPECT_NEAR(edgeClearance_m({}, {{0, -0.45}, outlineOfDisc(0.07), 1}), -0.02, 1e-12);
}

}  // namespace
}  // namespace conceptplan
