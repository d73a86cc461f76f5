#include "conceptplan/learner/frame_composition.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

constexpr int kWidth = 128, kHeight = 96;

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kWidth + x); }

/// A plane whose inverse depth rises along x, with instance 1 in columns 20-29, rows 40-49, 1 m
/// away.
RgbdImage plane() {
  RgbdImage image{kWidth, kHeight, {}, {}, {}};
  image.rgb.assign(3 * kWidth * kHeight, 100);
  image.mask.assign(kWidth * kHeight, 0);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      image.depth_m.push_back(1.0F / (0.4F + 0.001F * static_cast<float>(x)));
  for (int y = 40; y < 50; ++y)
    for (int x = 20; x < 30; ++x) {
      image.mask[at(x, y)] = 1;
      image.depth_m[at(x, y)] = 1;
    }
  return image;
}

/// An opaque square of 10 x 10 in the middle of its crop, which is centred at a pixel of a frame of
/// 384 x 256, 1.5 m away.
DrawnObject squareAt(int x, int y) {
  constexpr int kEdge = DrawnObject::kEdge;
  DrawnObject object;
  object.rgb.assign(3 * kEdge * kEdge, 0.5F);
  object.alpha.assign(kEdge * kEdge, 0);
  object.depth_m.assign(kEdge * kEdge, 1.5F);
  for (int v = 27; v < 37; ++v)
    for (int u = 27; u < 37; ++u) object.alpha[static_cast<std::size_t>(v * kEdge + u)] = 1;
  object.location = {static_cast<float>(x) / (kFrameWidth / 2.0F) - 1.0F,
                     static_cast<float>(y) / (kFrameHeight / 2.0F) - 1.0F, 0};
  return object;
}

TEST(FrameComposition, InverseDepthGoesOnLinearlyWhereTheInstanceStood) {
  RgbdImage image = plane();
  moveInstance(image, 1, squareAt(90, 20));
  for (int x = 20; x < 30; ++x) {
    EXPECT_EQ(image.mask[at(x, 45)], 0);
    EXPECT_NEAR(image.depth_m[at(x, 45)], 1.0F / (0.4F + 0.001F * static_cast<float>(x)), 1e-4);
  }
  EXPECT_EQ(image.mask[at(90, 20)], 1);
  EXPECT_EQ(image.depth_m[at(90, 20)], 1.5F);
  EXPECT_EQ(image.mask[at(84, 20)], 0);
}

TEST(FrameComposition, NearerObjectsHideTheDrawnOne) {
  RgbdImage image = plane();
  image.mask[at(90, 20)] = 2;  // nearer than the object
  image.depth_m[at(90, 20)] = 1.2F;
  image.mask[at(91, 20)] = 2;  // behind it
  image.depth_m[at(91, 20)] = 1.9F;
  const auto others = othersDepth_mm(image, 1);
  EXPECT_EQ(others[at(25, 45)], 0);
  EXPECT_EQ(others[at(90, 20)], 1200);
  const DrawnObject seen = hiddenBehind(squareAt(90, 20), others, kWidth);
  moveInstance(image, 1, seen);
  EXPECT_EQ(image.mask[at(90, 20)], 2);
  EXPECT_EQ(image.mask[at(91, 20)], 1);
  EXPECT_EQ(image.mask[at(92, 20)], 1);
}

TEST(FrameComposition, KeepsWhatLiesOutsideTheFrame) {
  RgbdImage image = plane();
  const DrawnObject object = squareAt(0, 0);
  moveInstance(image, 1, hiddenBehind(object, othersDepth_mm(image, 1), kWidth));
  EXPECT_EQ(image.mask[at(0, 0)], 1);
  EXPECT_EQ(image.mask[at(6, 0)], 0);
  EXPECT_EQ(image.mask.size(), static_cast<std::size_t>(kWidth * kHeight));
}

}  // namespace
}  // namespace conceptplan
