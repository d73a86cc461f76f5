#include "conceptplan/learner/background.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace conceptplan {
namespace {

constexpr int kWidth = 200, kHeight = 150;

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kWidth + x); }

/// A floor below a camera that looks at it askew: inverse depth falls to the far, upper edge.
/// brightness(right, ahead) of the floor, whose coordinates are in units of the camera's height.
RgbdImage floorSeenAskew(const std::function<double(double, double)>& brightness) {
  RgbdImage image{kWidth, kHeight, {}, {}, {}};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double inverse_depth = 0.5 + 0.005 * y;
      const double right = (x - 100) / (200 * inverse_depth), ahead = 1 / inverse_depth;
      image.depth_m.push_back(static_cast<float>(1 / inverse_depth));
      const auto value = static_cast<std::uint8_t>(std::lround(brightness(right, ahead)));
      image.rgb.insert(image.rgb.end(), {value, value, value});
    }
  image.mask.assign(kWidth * kHeight, 0);
  return image;
}

/// Stripes that run to the vanishing point, 0.1 wide, and cross lines.
double tiles(double right, double ahead) {
  return 120 + 60 * std::sin(20 * std::numbers::pi * right) +
         30 * std::sin(16 * std::numbers::pi * ahead);
}

/// Puts a block of one colour over the floor.
void cover(RgbdImage& image, std::uint8_t instance, int left, int top, int width, int height,
           std::array<std::uint8_t, 3> color) {
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) {
      std::copy(color.begin(), color.end(), &image.rgb[3 * at(x, y)]);
      image.mask[at(x, y)] = instance;
      image.depth_m[at(x, y)] = 0.5F;
    }
}

double rootMeanSquareError(const RgbdImage& found, const RgbdImage& truth,
                           const std::vector<std::uint8_t>& hole) {
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < hole.size(); ++i)
    if (hole[i] != 0) squares += std::pow(found.rgb[3 * i] - truth.rgb[3 * i], 2), ++count;
  return std::sqrt(squares / count);
}

TEST(Background, TakesAPieceOfTheSameFloorAlongItsPlane) {
  const RgbdImage truth = floorSeenAskew(tiles);
  RgbdImage image = truth;
  cover(image, 1, 60, 70, 30, 24, {200, 0, 0});
  const Background background = backgroundWithout(image, 1);
  // The brightness varies by 47 (root mean square), which is the error of the mean colour.
  EXPECT_LT(rootMeanSquareError(background.image, truth, background.hole), 9);
}

TEST(Background, ContinuesTheDepthOfTheFloorAndLeavesTheMask) {
  const RgbdImage truth = floorSeenAskew(tiles);
  RgbdImage image = truth;
  cover(image, 1, 60, 70, 30, 24, {200, 0, 0});
  cover(image, 2, 95, 70, 10, 10, {0, 0, 200});
  const Background background = backgroundWithout(image, 1);
  EXPECT_NEAR(background.image.depth_m[at(75, 80)], truth.depth_m[at(75, 80)], 1e-3);
  EXPECT_EQ(background.image.depth_m[at(97, 75)], 0.5F);
  EXPECT_EQ(background.image.mask[at(75, 80)], 0);
  EXPECT_EQ(background.image.mask[at(97, 75)], 2);
}

TEST(Background, ChangesNothingOutsideTheHole) {
  RgbdImage image = floorSeenAskew(tiles);
  cover(image, 1, 60, 70, 30, 24, {200, 0, 0});
  const Background background = backgroundWithout(image, 1);
  for (std::size_t i = 0; i < image.mask.size(); ++i) {
    if (background.hole[i] != 0) continue;
    ASSERT_EQ(background.image.rgb[3 * i], image.rgb[3 * i]);
    ASSERT_EQ(background.image.depth_m[i], image.depth_m[i]);
  }
}

TEST(Background, TakesNoColorOfOtherObjects) {
  RgbdImage image = floorSeenAskew([](double, double) { return 160.0; });
  cover(image, 1, 60, 70, 30, 24, {200, 0, 0});
  cover(image, 2, 95, 60, 20, 40, {0, 0, 200});
  // Within the first piece that is looked at, whose rim is the floor's.
  cover(image, 3, 28, 24, 6, 6, {0, 200, 0});
  const Background background = backgroundWithout(image, 1);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    if (background.hole[i / 3] == 0) continue;
    ASSERT_EQ(background.image.rgb[i], 160);
  }
}

TEST(Background, TakesNoPieceOfAnotherPlane) {
  RgbdImage image = floorSeenAskew([](double, double) { return 150.0; });
  for (int y = 0; y < kHeight; ++y)
    for (int x = 100; x < kWidth; ++x) {
      image.depth_m[at(x, y)] *= 1.5F;
      image.rgb[3 * at(x, y)] = static_cast<std::uint8_t>((x + y) % 4 < 2 ? 140 : 160);
    }
  // The plane of the object has no other place for a piece.
  cover(image, 1, 20, 60, 30, 24, {200, 0, 0});
  cover(image, 2, 0, 0, 100, 40, {0, 0, 200});
  cover(image, 3, 0, 105, 100, 45, {0, 200, 0});
  const Background background = backgroundWithout(image, 1);
  for (std::size_t i = 0; i < image.mask.size(); ++i) {
    if (background.hole[i] == 0) continue;
    ASSERT_EQ(background.image.rgb[3 * i], 150);
  }
}

TEST(Background, HoleIsNarrowerWhereNoLargerPieceIsWhole) {
  RgbdImage image = floorSeenAskew(tiles);
  cover(image, 1, 30, 60, 30, 24, {200, 0, 0});
  const auto area = [&] {
    const std::vector<std::uint8_t> hole = backgroundWithout(image, 1).hole;
    return std::count_if(hole.begin(), hole.end(), [](std::uint8_t flag) { return flag != 0; });
  };
  EXPECT_EQ(area(), (30 + 26) * (24 + 26));
  cover(image, 2, 0, 0, 200, 38, {0, 0, 200});
  cover(image, 3, 0, 110, 200, 40, {0, 200, 0});
  EXPECT_LT(area(), (30 + 26) * (24 + 26));
}

TEST(Background, FillsAHoleAtTheBorderWithColorsOfTheFrame) {
  const auto stripes = [](double right, double) { return right > 0 ? 180.0 : 100.0; };
  RgbdImage image = floorSeenAskew(stripes);
  cover(image, 1, 175, 70, 25, 20, {200, 0, 0});
  cover(image, 2, 0, 0, 200, 50, {0, 0, 200});
  const Background background = backgroundWithout(image, 1);
  for (std::size_t i = 0; i < image.mask.size(); ++i) {
    if (background.hole[i] == 0) continue;
    ASSERT_NEAR(background.image.rgb[3 * i], 180, 2);
  }
}

TEST(Background, LeavesPixelsOffThePlaneOutOfIt) {
  const RgbdImage truth = floorSeenAskew(tiles);
  RgbdImage image = truth;
  for (int y = 0; y < 68; ++y)
    for (int x = 0; x < kWidth; ++x) image.depth_m[at(x, y)] = 9;
  cover(image, 1, 60, 70, 30, 24, {200, 0, 0});
  const Background background = backgroundWithout(image, 1);
  EXPECT_NEAR(background.image.depth_m[at(75, 80)], truth.depth_m[at(75, 80)], 2e-3);
}

TEST(Background, ReadsNoPixelOutsideWhateverTheDepth) {
  for (const float gradient : {1.0F / 32, -1.0F / 32, 0.4F, 1e30F}) {
    RgbdImage image = floorSeenAskew(tiles);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        image.depth_m[at(x, y)] = 1 / (0.5F * (1 + gradient * static_cast<float>(y - 76)));
    cover(image, 1, 60, 70, 13, 13, {200, 0, 0});
    const Background background = backgroundWithout(image, 1);
    EXPECT_NE(background.image.rgb, image.rgb) << gradient;
  }
}

TEST(Background, FillsFramesOfAFewPixels) {
  for (const int width : {1, 2, 40}) {
    RgbdImage image{width, 1, {}, {}, {}};
    const auto pixels = static_cast<std::size_t>(width);
    image.rgb.assign(3 * pixels, 70);
    image.depth_m.assign(pixels, 1);
    image.mask.assign(pixels, 0);
    image.mask[0] = 255;
    const Background background = backgroundWithout(image, 255);
    EXPECT_EQ(background.image.rgb.back(), width > 8 ? 70 : 0) << width;
    EXPECT_EQ(background.image.mask[0], 0);
  }
}

TEST(Background, SpreadsTheColorsAroundWhereNoPieceIsWhole) {
  const auto slope = [](double right, double) { return 128 + 60 * right; };
  const RgbdImage truth = floorSeenAskew(slope);
  RgbdImage image = truth;
  cover(image, 1, 60, 50, 80, 60, {200, 0, 0});  // no other piece of floor is as large
  cover(image, 2, 0, 0, 200, 20, {0, 0, 200});
  cover(image, 3, 0, 130, 200, 20, {0, 200, 0});
  const Background background = backgroundWithout(image, 1);
  EXPECT_LT(rootMeanSquareError(background.image, truth, background.hole), 5);
}

TEST(Background, ContinuesWhatHasNoDepth) {
  RgbdImage image = floorSeenAskew([](double, double) { return 90.0; });
  cover(image, 1, 60, 70, 30, 24, {200, 0, 0});
  image.depth_m.assign(image.depth_m.size(), 0);
  const Background background = backgroundWithout(image, 1);
  EXPECT_EQ(background.image.rgb[3 * at(75, 80)], 90);
  EXPECT_EQ(background.image.depth_m[at(75, 80)], 0);
}

TEST(Background, AFrameFullOfTheObjectIsBlack) {
  RgbdImage image = floorSeenAskew(tiles);
  cover(image, 1, 0, 0, kWidth, kHeight, {200, 0, 0});
  const Background background = backgroundWithout(image, 1);
  EXPECT_EQ(background.image.rgb[3 * at(75, 80)], 0);
  EXPECT_EQ(background.image.depth_m[at(75, 80)], 0);
}

TEST(Background, NamesAMissingInstanceAndPartsOfOtherSizes) {
  RgbdImage image = floorSeenAskew(tiles);
  cover(image, 1, 60, 70, 30, 24, {200, 0, 0});
  EXPECT_THAT([&] { backgroundWithout(image, 7); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("no instance 7")));
  EXPECT_THROW(backgroundWithout(image, 0), std::invalid_argument);
  image.depth_m.pop_back();
  EXPECT_THAT([&] { backgroundWithout(image, 1); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("one size")));
}

TEST(Background, HoleGrowsByThirteenPixelsButSparesOtherObjects) {
  RgbdImage image = floorSeenAskew(tiles);
  cover(image, 1, 60, 70, 1, 1, {200, 0, 0});
  cover(image, 2, 61, 70, 1, 1, {0, 0, 200});
  const std::vector<std::uint8_t> hole = backgroundWithout(image, 1).hole;
  for (const auto& [x, y] : {std::pair(60, 70), {47, 70}, {60, 57}, {73, 83}})
    EXPECT_EQ(hole[at(x, y)], 1) << x << ", " << y;
  for (const auto& [x, y] : {std::pair(61, 70), {46, 70}, {60, 56}, {60, 84}})
    EXPECT_EQ(hole[at(x, y)], 0) << x << ", " << y;
}

}  // namespace
}  // namespace conceptplan
