#include "conceptplan/learner/turn_residual.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "conceptplan/domain/rendering/renderer.hpp"

namespace conceptplan {
namespace {

constexpr ObjectState kPhone{ObjectType::kCellphone, {1, 1}, 0, 2, 3};

RgbdImage pictureOf(const ObjectState& object, const Appearance& appearance = {7, {}}) {
  Renderer renderer;
  World world;
  world.objects = {object};
  return renderer.render(world, appearance);
}

ObjectView viewOf(const RgbdImage& image, const ObjectState& object) {
  return {image, 1, Workbench{}.p_WCell(object.cell)};
}

/// The object after quarter turns, in another cell and of another colour.
ObjectState turned(ObjectState object, int quarter_turns) {
  object.rotation = (object.rotation + quarter_turns) % 4;
  object.cell = {2, 3};
  object.color = (object.color + 3) % 6;
  return object;
}

/// By how much half a turn more than the right turn fits worse.
double gain(const ObjectState& before, int quarter_turns, const Appearance& appearance = {7, {}},
            const Camera& camera = standardCamera()) {
  const ObjectState after = turned(before, quarter_turns);
  const RgbdImage first = pictureOf(before, appearance), second = pictureOf(after, appearance);
  const ObjectView seen_before = viewOf(first, before), seen_after = viewOf(second, after);
  return turnResidual(seen_before, seen_after, quarter_turns + 2, camera) -
         turnResidual(seen_before, seen_after, quarter_turns, camera);
}

/// The objects that no model has learned, in each of their rotations, turned in each way.
TEST(TurnResidual, TellsATurnFromItsOpposite) {
  for (const ObjectType type : {ObjectType::kCellphone, ObjectType::kDishSponge,
                                ObjectType::kSaltshaker, ObjectType::kPotato})
    for (int rotation = 0; rotation < 4; ++rotation)
      for (int turns = 0; turns < 4; ++turns)
        EXPECT_GT(gain({type, {1, 1}, rotation, 2, 3}, turns), 0.05)
            << name(type) << " from " << rotation << " by " << turns;
}

TEST(TurnResidual, IsNearlyZeroForTheSamePicture) {
  const RgbdImage image = pictureOf(kPhone);
  const ObjectView view = viewOf(image, kPhone);
  EXPECT_LT(turnResidual(view, view, 0, standardCamera()), 0.01);
  EXPECT_GT(turnResidual(view, view, 2, standardCamera()), 0.2);
}

TEST(TurnResidual, TakesTurnsModuloFour) {
  const ObjectState after = turned(kPhone, 1);
  const RgbdImage first = pictureOf(kPhone), second = pictureOf(after);
  const ObjectView seen_before = viewOf(first, kPhone), seen_after = viewOf(second, after);
  const auto residual = [&](int turns) {
    return turnResidual(seen_before, seen_after, turns, standardCamera());
  };
  EXPECT_EQ(residual(1), residual(5));
  EXPECT_EQ(residual(1), residual(-3));
  EXPECT_LT(residual(1), std::min({residual(0), residual(2), residual(3)}));
}

/// Nothing is told by what hides a part.
TEST(TurnResidual, AllowsForWhatIsHidden) {
  const ObjectState after = turned(kPhone, 2);
  const RgbdImage first = pictureOf(kPhone);
  RgbdImage second = pictureOf(after);
  const std::size_t seen = static_cast<std::size_t>(std::ranges::count(second.mask, 1));
  std::size_t hidden = 0;
  for (std::size_t i = second.mask.size(); i-- > 0 && hidden < seen / 3;)  // from the front on
    if (second.mask[i] == 1) {
      second.mask[i] = 2;
      second.depth_m[i] -= 0.1F;
      ++hidden;
    }
  const ObjectView seen_before = viewOf(first, kPhone), seen_after = viewOf(second, after);
  EXPECT_LT(turnResidual(seen_before, seen_after, 2, standardCamera()) + 0.1,
            turnResidual(seen_before, seen_after, 0, standardCamera()));
}

TEST(TurnResidual, BearsACameraThatIsNotWhereItIsSaidToBe) {
  Camera off = standardCamera();
  off.X_WC.pretranslate(Eigen::Vector3d(0.02, -0.015, 0.03));
  EXPECT_GT(gain(kPhone, 1, {7, {}}, off), 0.1);
  EXPECT_GT(gain(kPhone, 2, {7, {}}, off), 0.1);
  EXPECT_GT(gain(kPhone, 2, {7, RenderDomain::kShifted}), 0.1);
}

TEST(TurnResidual, IsLargestWhereTheObjectIsNotSeen) {
  const RgbdImage image = pictureOf(kPhone);
  RgbdImage dark = image;
  std::ranges::fill(dark.depth_m, 0.0F);
  const ObjectView view = viewOf(image, kPhone);
  EXPECT_EQ(turnResidual(view, {image, 9, view.p_WAxis}, 0, standardCamera()), 1);
  EXPECT_EQ(turnResidual({dark, 1, view.p_WAxis}, view, 0, standardCamera()), 1);
  for (const float depth_m :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), -1.0F}) {
    std::ranges::fill(dark.depth_m, depth_m);
    EXPECT_EQ(turnResidual({dark, 1, view.p_WAxis}, view, 0, standardCamera()), 1) << depth_m;
  }
}

TEST(TurnResidual, BearsPixelsOfUnknownDepth) {
  const ObjectState after = turned(kPhone, 2);
  RgbdImage first = pictureOf(kPhone), second = pictureOf(after);
  const std::array<float, 4> unknown{0, -1, std::numeric_limits<float>::infinity(),
                                     std::numeric_limits<float>::quiet_NaN()};
  for (std::size_t i = 0; i < first.depth_m.size(); i += 7)
    first.depth_m[i] = second.depth_m[i] = unknown[i / 7 % unknown.size()];
  const ObjectView seen_before = viewOf(first, kPhone), seen_after = viewOf(second, after);
  EXPECT_LT(turnResidual(seen_before, seen_after, 2, standardCamera()) + 0.1,
            turnResidual(seen_before, seen_after, 0, standardCamera()));
}

TEST(TurnResidual, RefusesAPictureOfAnotherSize) {
  const RgbdImage image = pictureOf(kPhone);
  Camera small = standardCamera();
  small.width = 100;
  const ObjectView view = viewOf(image, kPhone);
  EXPECT_THAT([&] { turnResidual(view, view, 0, small); },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::HasSubstr("a picture of 384 x 256 is not of the camera's size")));
}

}  // namespace
}  // namespace conceptplan
