#include "conceptplan/domain/object_crop.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace conceptplan {
namespace {

RgbdImage blank(int width, int height) {
  RgbdImage image;
  image.width = width;
  image.height = height;
  const auto pixels = static_cast<std::size_t>(width * height);
  image.rgb.assign(3 * pixels, 200);
  image.depth_m.assign(pixels, 2.5F);
  image.mask.assign(pixels, 0);
  return image;
}

void mark(RgbdImage& image, int x, int y, std::uint8_t instance) {
  image.mask[static_cast<std::size_t>(y * image.width + x)] = instance;
}

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * ObjectCrop::kEdge + x); }

int covered(const ObjectCrop& crop) {
  return std::accumulate(crop.mask.begin(), crop.mask.end(), 0);
}

TEST(CropObject, CentresTheBoundingBoxAndBlackensAllElse) {
  RgbdImage image = blank(200, 150);
  mark(image, 100, 60, 3);
  mark(image, 109, 79, 3);
  mark(image, 105, 70, 2);
  const ObjectCrop crop = cropObject(image, 3);
  EXPECT_EQ(crop.left, 105 - 32);
  EXPECT_EQ(crop.top, 70 - 32);
  EXPECT_EQ(covered(crop), 2);
  EXPECT_EQ(crop.mask[at(100 - crop.left, 60 - crop.top)], 1);
  EXPECT_EQ(crop.rgb[3 * at(100 - crop.left, 60 - crop.top)], 200);
  EXPECT_EQ(crop.depth_m[at(109 - crop.left, 79 - crop.top)], 2.5F);
  EXPECT_EQ(crop.rgb[3 * at(32, 32)], 0) << "another instance";
  EXPECT_EQ(crop.depth_m[at(0, 0)], 0);
}

TEST(CropObject, ReachesBeyondTheFrame) {
  RgbdImage image = blank(80, 70);
  mark(image, 0, 0, 1);
  const ObjectCrop crop = cropObject(image, 1);
  EXPECT_EQ(crop.left, -32);
  EXPECT_EQ(crop.top, -32);
  EXPECT_EQ(crop.mask[at(32, 32)], 1);
  EXPECT_EQ(covered(crop), 1);
}

TEST(CropObject, CutsAnObjectThatIsTooLarge) {
  RgbdImage image = blank(200, 150);
  for (int x = 20; x < 180; ++x) mark(image, x, 75, 1);
  const ObjectCrop crop = cropObject(image, 1);
  EXPECT_EQ(covered(crop), ObjectCrop::kEdge);
  EXPECT_EQ(crop.left, 100 - 32);
}

TEST(CropObject, RejectsAnAbsentInstanceAndTheBackground) {
  const RgbdImage image = blank(20, 20);
  EXPECT_THAT([&] { cropObject(image, 7); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("instance id 7")));
  EXPECT_THROW(cropObject(image, 0), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
