#include "conceptplan/domain/rendering/appearance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "rendering/color.hpp"

namespace conceptplan {
namespace {

TEST(ColorSample, RepeatsAfterTwentySeedsAndDiffersBetweenObjects) {
  EXPECT_EQ(colorSample({5}, 0), colorSample({25}, 0));
  EXPECT_NE(colorSample({5}, 0), colorSample({6}, 0));
  std::set<int> samples;
  for (std::size_t object = 0; object < kColorSamples; ++object) {
    samples.insert(colorSample({11}, object));
  }
  EXPECT_EQ(samples.size(), kColorSamples);
  EXPECT_GE(colorSample({std::numeric_limits<std::uint64_t>::max()}, 9), 0);
}

TEST(BodyAlbedo, KeepsNearTheNamedHueAndGivesTwentyDistinctSamples) {
  for (int color = 0; color < 6; ++color) {
    const Eigen::Vector3f pure = rendering::linear(rendering::fromHsv(60.0F * color, 1, 1));
    std::set<std::array<float, 3>> distinct;
    for (int sample = 0; sample < kColorSamples; ++sample) {
      const Eigen::Vector3f albedo = rendering::bodyAlbedo(color, sample);
      distinct.insert({albedo.x(), albedo.y(), albedo.z()});
      EXPECT_GT(albedo.minCoeff(), 0);
      EXPECT_LT(albedo.maxCoeff(), 1);
      EXPECT_GT(albedo.normalized().dot(pure.normalized()), 0.95F) << color << " " << sample;
    }
    EXPECT_EQ(distinct.size(), kColorSamples);
  }
}

TEST(FromHsv, MeetsTheCornersOfTheColorCube) {
  using Eigen::Vector3f;
  const std::array<Vector3f, 6> corners{Vector3f(1, 0, 0), Vector3f(1, 1, 0), Vector3f(0, 1, 0),
                                        Vector3f(0, 1, 1), Vector3f(0, 0, 1), Vector3f(1, 0, 1)};
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(rendering::fromHsv(60.0F * i, 1, 1).isApprox(corners[static_cast<std::size_t>(i)]));
  }
}

TEST(Encode, IsTheSrgbCurveBelowItsKneeAndNeverFallsAbove) {
  EXPECT_EQ(rendering::encode(0), 0);
  EXPECT_EQ(rendering::encode(-1), 0);
  for (const float srgb : {0.1F, 0.3F, 0.5F, 0.8F}) {
    const float linear = rendering::linear(Eigen::Vector3f::Constant(srgb)).x();
    EXPECT_NEAR(rendering::encode(linear), 255 * srgb, 1);
  }
  int last = 0;
  for (float x = 0; x < 3; x += 0.01F) {
    EXPECT_GE(rendering::encode(x), last);
    last = rendering::encode(x);
  }
  EXPECT_GT(last, 250);
}

}  // namespace
}  // namespace conceptplan
