#include "conceptplan/domain/model/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace conceptplan {
namespace {

constexpr std::size_t kCount = Outline::kDirections;

double reach_m(const std::vector<Eigen::Vector2d>& points, std::size_t k) {
  double farthest_m = -1;
  for (const Eigen::Vector2d& p : points)
    farthest_m = std::max(farthest_m, outlineDirection(k).dot(p));
  return farthest_m;
}

Outline drawn(std::mt19937_64& random) {
  Outline outline;
  for (double& support_m : outline.support_m) {
    support_m = 0.02 + 0.1 * static_cast<double>(random() >> 11) * 0x1p-53;
  }
  return outline;
}

TEST(Outline, DirectionsAreATurnInSixteenSteps) {
  EXPECT_TRUE(outlineDirection(0).isApprox(Eigen::Vector2d(1, 0)));
  EXPECT_TRUE(outlineDirection(2).isApprox(Eigen::Vector2d(1, 1).normalized()));
  for (std::size_t k = 0; k < kCount; ++k) {
    EXPECT_TRUE(outlineDirection(opposite(k)).isApprox(-outlineDirection(k)));
  }
}

TEST(Outline, OfASquareHasItsCorners) {
  const std::vector<Eigen::Vector2d> corners = cornersOf(outlineOfSquare(0.1));
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_TRUE(corners[0].isApprox(Eigen::Vector2d(0.1, 0.1)));
  EXPECT_TRUE(corners[1].isApprox(Eigen::Vector2d(-0.1, 0.1)));
  EXPECT_NEAR(circumradius_m(outlineOfSquare(0.1)), 0.1 * std::numbers::sqrt2, 1e-12);
}

TEST(Outline, OfADiscSurroundsIt) {
  const std::vector<Eigen::Vector2d> corners = cornersOf(outlineOfDisc(0.1));
  ASSERT_EQ(corners.size(), kCount);
  for (const Eigen::Vector2d& corner : corners) {
    EXPECT_NEAR(corner.norm(), 0.1 / std::cos(std::numbers::pi / kCount), 1e-12);
  }
}

TEST(Outline, TightenedItReachesEachSupportAndNoFurther) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    const Outline loose = drawn(random);
    const Outline tight = tightened(loose);
    const std::vector<Eigen::Vector2d> corners = cornersOf(tight);
    ASSERT_GE(corners.size(), 3u);
    for (std::size_t k = 0; k < kCount; ++k) {
      EXPECT_LE(tight.support_m[k], loose.support_m[k]);
      EXPECT_NEAR(reach_m(corners, k), tight.support_m[k], 1e-9);
    }
    // Nothing is lost: a point of each ray is in the one where it is in the other.
    for (int ray = 0; ray < 50; ++ray) {
      const Eigen::Vector2d along(std::cos(0.1 + ray), std::sin(0.1 + ray));
      double to_loose_m = 1, to_tight_m = 1;
      for (std::size_t k = 0; k < kCount; ++k) {
        const double slope = outlineDirection(k).dot(along);
        if (slope <= 1e-9) continue;
        to_loose_m = std::min(to_loose_m, loose.support_m[k] / slope);
        to_tight_m = std::min(to_tight_m, tight.support_m[k] / slope);
      }
      EXPECT_NEAR(to_loose_m, to_tight_m, 1e-9);
    }
  }
}

TEST(Outline, ClippedItIsInBothAndLeftAloneWhereItWas) {
  const Outline disc = outlineOfDisc(0.1);
  EXPECT_EQ(clipped(disc, outlineOfSquare(0.11)), disc);
  const Outline octagon = clipped(disc, outlineOfSquare(0.09));
  for (const Eigen::Vector2d& corner : cornersOf(octagon)) {
    EXPECT_LE(corner.lpNorm<Eigen::Infinity>(), 0.09 + 1e-12);
    EXPECT_LE(corner.norm(), 0.1 / std::cos(std::numbers::pi / kCount) + 1e-12);
  }
  EXPECT_NEAR(octagon.support_m[0], 0.09, 1e-12);
  EXPECT_NEAR(octagon.support_m[2], 0.1, 1e-12);
}

TEST(Outline, ItsBoxHoldsItAndNoMore) {
  std::mt19937_64 random(3);
  const Outline outline = tightened(drawn(random));
  Eigen::Vector2d low_m(1, 1), high_m(-1, -1);
  for (const Eigen::Vector2d& corner : cornersOf(outline)) {
    low_m = low_m.cwiseMin(corner);
    high_m = high_m.cwiseMax(corner);
  }
  EXPECT_TRUE(boxOf(outline).low_m.isApprox(low_m));
  EXPECT_TRUE(boxOf(outline).high_m.isApprox(high_m));
}

TEST(Outline, AUnionReachesAsFarAsEither) {
  std::mt19937_64 random(2);
  const Outline a = tightened(drawn(random));
  const Outline b = tightened(drawn(random));
  std::vector<Eigen::Vector2d> corners = cornersOf(a);
  const std::vector<Eigen::Vector2d> more = cornersOf(b);
  corners.insert(corners.end(), more.begin(), more.end());
  for (std::size_t k = 0; k < kCount; ++k) {
    EXPECT_NEAR(unionOf(a, b).support_m[k], reach_m(corners, k), 1e-9);
  }
}

}  // namespace
}  // namespace conceptplan
