#include "conceptplan/learner/picture_residual.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace conceptplan {
namespace {

constexpr int kEdge = EncoderInput::kEdge;
constexpr int kPixels = EncoderInput::kPixels;
constexpr std::array<float, 3> kPlace{-0.5F, 0.25F, 0.5F};  // pixel (96, 160), 2.25 m away

/// A square of 20 x 20 pixels of one colour, from (left, top) of the crop on.
EncoderInput seenSquare(int left = 22, int top = 22) {
  EncoderInput seen{std::vector<std::uint8_t>(EncoderInput::kChannels * kPixels, 0), kPlace};
  for (int y = top; y < top + 20; ++y)
    for (int x = left; x < left + 20; ++x) {
      const auto pixel = static_cast<std::size_t>(y * kEdge + x);
      for (std::size_t channel = 0; channel < 3; ++channel)
        seen.planes[channel * kPixels + pixel] = 51;
      seen.planes[3 * kPixels + pixel] = 128;
      seen.planes[4 * kPixels + pixel] = 255;
    }
  return seen;
}

/// The same square as it is drawn, `columns` to the right.
DrawnObject drawnSquare(int columns = 0) {
  DrawnObject drawn;
  drawn.rgb.assign(3 * kPixels, 0.2F);
  drawn.alpha.assign(kPixels, 0);
  drawn.depth_m.assign(kPixels, 2.25F);
  for (int y = 22; y < 42; ++y)
    std::fill_n(drawn.alpha.begin() + y * kEdge + 22 + columns, 20, 1.0F);
  drawn.location = kPlace;
  return drawn;
}

TEST(PictureResidual, OfAnObjectThatLooksAsItIsDrawnIsZero) {
  const PictureResidual residual = pictureResidual(seenSquare(), drawnSquare());
  EXPECT_EQ(residual.silhouette, 0);
  EXPECT_NEAR(residual.depth_m, 0, 1e-6);
  EXPECT_NEAR(residual.color, 0, 1e-6);
}

TEST(PictureResidual, ComparesPixelsOfTheFrameAndNotOfTheCrops) {
  DrawnObject drawn = drawnSquare(5);
  drawn.location[0] -= 5 / (kFrameWidth / 2.0F);
  EXPECT_EQ(pictureResidual(seenSquare(), drawn).silhouette, 0);
}

TEST(PictureResidual, SilhouetteCountsWhatOneCoversAlone) {
  // 5 of 20 columns are seen and not drawn, 5 drawn and not seen.
  EXPECT_DOUBLE_EQ(pictureResidual(seenSquare(), drawnSquare(5)).silhouette, 0.5);
}

TEST(PictureResidual, WhatMayBeHiddenIsNotMissed) {
  std::vector<std::uint8_t> hidden(kPixels, 0);
  for (int y = 0; y < kEdge; ++y) std::fill_n(hidden.begin() + y * kEdge + 42, kEdge - 42, 1);
  EXPECT_DOUBLE_EQ(pictureResidual(seenSquare(), drawnSquare(5), hidden).silhouette, 0.25);
}

TEST(PictureResidual, DepthIsWithoutItsMeanAndCutOff) {
  DrawnObject drawn = drawnSquare();
  for (float& depth_m : drawn.depth_m) depth_m += 0.1F;
  EXPECT_NEAR(pictureResidual(seenSquare(), drawn).depth_m, 0, 1e-6);
  for (int y = 22; y < 42; ++y)
    for (int x = 22; x < 42; ++x)
      drawn.depth_m[static_cast<std::size_t>(y * kEdge + x)] = x < 32 ? 2.24F : 2.26F;
  EXPECT_NEAR(pictureResidual(seenSquare(), drawn).depth_m, 0.01, 1e-6);
  for (float& depth_m : drawn.depth_m) depth_m = depth_m < 2.25F ? 1 : 3;
  EXPECT_NEAR(pictureResidual(seenSquare(), drawn).depth_m, 0.05, 1e-6);
}

TEST(PictureResidual, ColorIsTheMeanOfTheChannels) {
  DrawnObject drawn = drawnSquare();
  std::fill_n(drawn.rgb.begin(), kPixels, 0.8F);
  EXPECT_NEAR(pictureResidual(seenSquare(), drawn).color, 0.2, 1e-6);
}

TEST(PictureResidual, IsLargestWhereNothingIsCommon) {
  const PictureResidual residual = pictureResidual(seenSquare(0, 0), drawnSquare());
  EXPECT_EQ(residual.silhouette, 2);
  EXPECT_EQ(residual.depth_m, 0.05);
  EXPECT_EQ(residual.color, 1);
}

TEST(PictureResidual, IsWithinLimitsWhereNoMeasureExceedsThem) {
  const PictureResidual limits{0.2, 0.01, 0.1};
  EXPECT_TRUE(limits.within(limits));
  EXPECT_FALSE((PictureResidual{0.3, 0, 0}).within(limits));
  EXPECT_FALSE((PictureResidual{0, 0.02, 0}).within(limits));
  EXPECT_FALSE((PictureResidual{0, 0, 0.2}).within(limits));
}

TEST(PictureResidual, RefusesOtherSizesAndNoObject) {
  EncoderInput empty = seenSquare();
  std::fill(empty.planes.begin(), empty.planes.end(), std::uint8_t{0});
  EXPECT_THAT([&] { pictureResidual(empty, drawnSquare()); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("no pixel")));
  const std::vector<std::uint8_t> hidden(10, 0);
  EXPECT_THAT([&] { pictureResidual(seenSquare(), drawnSquare(), hidden); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("64 x 64")));
}

TEST(HiddenPixels, AreThoseOfOthersAndOutsideTheFrame) {
  RgbdImage image{100, 200, {}, {}, {}};  // ends 36 columns right of the crop's first one
  image.mask.assign(100 * 200, 0);
  const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 100 + x); };
  image.mask[at(70, 150)] = 1;
  image.mask[at(71, 150)] = 2;
  const std::vector<std::uint8_t> hidden = hiddenPixels(image, 1, seenSquare());
  const auto of = [&](int x, int y) {  // the crop begins at (64, 128)
    return hidden[static_cast<std::size_t>((y - 128) * kEdge + x - 64)];
  };
  EXPECT_EQ(of(69, 150), 0);
  EXPECT_EQ(of(70, 150), 0);
  EXPECT_EQ(of(71, 150), 1);
  EXPECT_EQ(of(99, 150), 0);
  EXPECT_EQ(of(100, 150), 1);
}

}  // namespace
}  // namespace conceptplan
