#include "conceptplan/learner/frame_window.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "conceptplan/learner/frame_composition.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kPixels = FrameWindow::kPixels;

TEST(FrameWindow, StaysWithinTheFrame) {
  EXPECT_EQ(windowAround(0, 0, 384, 256).left, 0);
  EXPECT_EQ(windowAround(383, 255, 384, 256).left, 384 - 96);
  EXPECT_EQ(windowAround(383, 255, 384, 256).top, 256 - 96);
  EXPECT_EQ(windowAround(200, 100, 384, 256).left, 152);
  EXPECT_THROW(windowAround(10, 10, 90, 256), std::invalid_argument);
}

TEST(FrameWindow, TakesPlacesFarOutsideAndRefusesThoseThatAreNone) {
  constexpr double kHuge = 1e300;
  EXPECT_EQ(windowAround(kHuge, -kHuge, 384, 256).left, 384 - 96);
  EXPECT_EQ(windowAround(kHuge, -kHuge, 384, 256).top, 0);
  EXPECT_THAT([] { windowAround(std::nan(""), 3, 384, 256); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("no pixel lies")));
  DrawnObject object;
  object.rgb.assign(3 * 64 * 64, 0.5F);
  object.alpha.assign(64 * 64, 1.0F);
  object.depth_m.assign(64 * 64, 1.0F);
  object.location = {3e38F, -3e38F, 0};
  EXPECT_EQ(cropCorner(object.location).left, 1'000'000 - 32);
  EXPECT_EQ(cropCorner(object.location).top, -1'000'000 - 32);
  const std::vector<std::uint16_t> others(384 * 256, 500);
  EXPECT_EQ(hiddenBehind(object, others, 384).alpha, object.alpha);
  object.location[0] = std::nanf("");
  EXPECT_THAT([&] { cropCorner(object.location); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("lies at nan")));
}

TEST(FrameWindow, CutsFloorHoleAndObject) {
  std::vector<std::uint8_t> rgb(3 * 384 * 256, 255), hole(384 * 256, 0);
  hole[130 * 384 + 200] = 1;
  DrawnObject object;
  object.rgb.assign(3 * 64 * 64, 0.5F);
  object.alpha.assign(64 * 64, 1.0F);
  object.location = {0, 0, 0};  // crop from (160, 96)
  const FrameWindow window = cutWindow(rgb, hole, 384, {150, 90}, object);
  const auto at = [&](int plane, int x, int y) {
    return window.planes[static_cast<std::size_t>(plane) * kPixels +
                         static_cast<std::size_t>((y - 90) * 96 + x - 150)];
  };
  EXPECT_EQ(at(0, 151, 91), 1.0F);
  EXPECT_EQ(at(0, 200, 130), 1.0F);  // the floor goes on in the hole
  EXPECT_EQ(at(3, 200, 130), 1.0F);
  EXPECT_EQ(at(3, 201, 130), 0.0F);
  EXPECT_EQ(at(7, 159, 100), 0.0F);
  EXPECT_EQ(at(7, 160, 96), 1.0F);
  EXPECT_EQ(at(5, 223, 159), 0.5F);
  EXPECT_EQ(at(7, 224, 159), 0.0F);
}

}  // namespace
}  // namespace conceptplan
