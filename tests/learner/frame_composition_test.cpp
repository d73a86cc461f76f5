#include "conceptplan/learner/frame_composition.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

constexpr int kWidth = 128, kHeight = 96;

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kWidth + x); }

/// A floor 2.5 m away, without objects.
RgbdImage emptyFloor() {
  RgbdImage image{kWidth, kHeight, {}, {}, {}};
  image.rgb.assign(3 * kWidth * kHeight, 100);
  image.mask.assign(kWidth * kHeight, 0);
  image.depth_m.assign(kWidth * kHeight, 2.5F);
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

TEST(FrameComposition, PlacesMaskAndDepthWhereTheObjectIsOpaque) {
  RgbdImage image = emptyFloor();
  placeInstance(image, 1, squareAt(90, 20));
  EXPECT_EQ(image.mask[at(90, 20)], 1);
  EXPECT_EQ(image.depth_m[at(90, 20)], 1.5F);
  EXPECT_EQ(image.mask[at(84, 20)], 0);
  EXPECT_EQ(image.depth_m[at(84, 20)], 2.5F);
}

TEST(FrameComposition, NearerObjectsHideTheDrawnOne) {
  RgbdImage image = emptyFloor();
  image.mask[at(90, 20)] = 2;  // nearer than the object
  image.depth_m[at(90, 20)] = 1.2F;
  image.mask[at(91, 20)] = 2;  // behind it
  image.depth_m[at(91, 20)] = 1.9F;
  const auto others = objectsDepth_mm(image);
  EXPECT_EQ(others[at(25, 45)], 0);
  EXPECT_EQ(others[at(90, 20)], 1200);
  const DrawnObject seen = hiddenBehind(squareAt(90, 20), others, kWidth);
  placeInstance(image, 1, seen);
  EXPECT_EQ(image.mask[at(90, 20)], 2);
  EXPECT_EQ(image.mask[at(91, 20)], 1);
  EXPECT_EQ(image.mask[at(92, 20)], 1);
}

TEST(FrameComposition, KeepsWhatLiesOutsideTheFrame) {
  RgbdImage image = emptyFloor();
  const DrawnObject object = squareAt(0, 0);
  placeInstance(image, 1, hiddenBehind(object, objectsDepth_mm(image), kWidth));
  EXPECT_EQ(image.mask[at(0, 0)], 1);
  EXPECT_EQ(image.mask[at(6, 0)], 0);
  EXPECT_EQ(image.mask.size(), static_cast<std::size_t>(kWidth * kHeight));
}

}  // namespace
}  // namespace conceptplan
