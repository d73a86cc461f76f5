#include "conceptplan/domain/rendering/renderer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>

namespace conceptplan {
namespace {

constexpr Appearance kStandard{17, RenderDomain::kStandard};
constexpr Appearance kShifted{17, RenderDomain::kShifted};

World worldOf(std::vector<ObjectState> objects) {
  World world;
  world.objects = std::move(objects);
  return world;
}

World mixedWorld() {
  return worldOf({{ObjectType::kCup, {0, 0}, 1, 0, 3},
                  {ObjectType::kTomato, {1, 2}, 2, 4, 2},
                  {ObjectType::kDyer, {2, 4}, 0, 1, 1},
                  {ObjectType::kBread, {0, 3}, 3, 5, 0}});
}

bool same(const RgbdImage& a, const RgbdImage& b) {
  return a.rgb == b.rgb && a.depth_m == b.depth_m && a.mask == b.mask;
}

long count(const RgbdImage& image, std::uint8_t instance) {
  return std::count(image.mask.begin(), image.mask.end(), instance);
}

int area(const ObjectCrop& crop) { return std::accumulate(crop.mask.begin(), crop.mask.end(), 0); }

std::string describe(const ObjectState& object) {
  return std::string(name(object.type)) + " at (" + std::to_string(object.cell.x) + ", " +
         std::to_string(object.cell.y) + ") rotation " + std::to_string(object.rotation) +
         " size " + std::to_string(object.size);
}

TEST(Renderer, GivesAFrameWithAnInstanceForEachObject) {
  const World world = mixedWorld();
  const RgbdImage image = Renderer().render(world, kStandard);
  EXPECT_EQ(image.width, kFrameWidth);
  EXPECT_EQ(image.height, kFrameHeight);
  ASSERT_EQ(image.rgb.size(), 3U * kFrameWidth * kFrameHeight);
  ASSERT_EQ(image.depth_m.size(), 1U * kFrameWidth * kFrameHeight);
  ASSERT_EQ(image.mask.size(), 1U * kFrameWidth * kFrameHeight);
  for (std::uint8_t id = 1; id <= world.objects.size(); ++id) EXPECT_GT(count(image, id), 80);
  EXPECT_EQ(*std::max_element(image.mask.begin(), image.mask.end()), world.objects.size());
  EXPECT_GT(*std::min_element(image.depth_m.begin(), image.depth_m.end()), 0.5F);
}

TEST(Renderer, DepthLeadsBackToTheObjectsAndTheTable) {
  const World world = mixedWorld();
  const RgbdImage image = Renderer().render(world, kStandard);
  const Camera camera = Renderer::camera(kStandard);
  long table = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto i = static_cast<std::size_t>(y * image.width + x);
      const Eigen::Vector3d p_W = camera.unproject({x + 0.5, y + 0.5}, image.depth_m[i]);
      if (image.mask[i] == 0) {
        const bool on_table = std::abs(p_W.x()) < 0.39 && std::abs(p_W.y() - 0.1) < 0.6;
        if (!on_table) continue;
        ++table;
        ASSERT_NEAR(p_W.z(), 0, 1e-4) << x << ", " << y;
        continue;
      }
      const ObjectState& object = world.objects[image.mask[i] - 1U];
      const double half = 0.0851 * sizeScale(object.size);
      const Eigen::Vector2d offset = p_W.head<2>() - world.workbench.p_WCell(object.cell);
      ASSERT_LT(offset.cwiseAbs().maxCoeff(), half) << describe(object);
      ASSERT_GT(p_W.z(), -1e-3) << describe(object);
      ASSERT_LT(p_W.z(), 0.15 * sizeScale(object.size)) << describe(object);
    }
  }
  EXPECT_GT(table, 30000);
}

TEST(Renderer, GivesTheSameBytesWhateverItDrewBefore) {
  Renderer first;
  const RgbdImage standard = first.render(mixedWorld(), kStandard);
  const RgbdImage shifted = first.render(mixedWorld(), kShifted);
  World wide = mixedWorld();
  wide.workbench.columns = 5;
  first.render(wide, kStandard);
  first.renderForeground(Workbench{}, mixedWorld().objects[0], {99});
  EXPECT_TRUE(same(first.render(mixedWorld(), kStandard), standard));

  Renderer second;
  second.renderForeground(Workbench{}, mixedWorld().objects[1], kShifted);
  EXPECT_TRUE(same(second.render(mixedWorld(), kShifted), shifted));
  EXPECT_TRUE(same(second.render(mixedWorld(), kStandard), standard));
}

TEST(Renderer, GivesTheSameBytesOnManyThreads) {
  const RgbdImage expected = Renderer().render(mixedWorld(), kStandard);
  std::vector<RgbdImage> images(3);
  {
    std::vector<std::jthread> threads;
    for (RgbdImage& image : images) {
      threads.emplace_back([&image] { image = Renderer().render(mixedWorld(), kStandard); });
    }
  }
  for (const RgbdImage& image : images) EXPECT_TRUE(same(image, expected));
}

TEST(Renderer, ForegroundIsTheCropOfAFrame) {
  Renderer renderer;
  for (int i = 0; i < static_cast<int>(kNumObjectTypes); ++i) {
    for (const Appearance& appearance : {kStandard, kShifted}) {
      const ObjectState object{
          static_cast<ObjectType>(i), {i % 3, i % 5}, i % 4, i % 6, (i / 3) % 4};
      const ObjectCrop crop = renderer.renderForeground(Workbench{}, object, appearance);
      const ObjectCrop cut = cropObject(renderer.render(worldOf({object}), appearance), 1);
      EXPECT_EQ(crop.left, cut.left) << describe(object);
      EXPECT_EQ(crop.top, cut.top) << describe(object);
      EXPECT_EQ(crop.mask, cut.mask) << describe(object);
      EXPECT_EQ(crop.depth_m, cut.depth_m) << describe(object);
      EXPECT_EQ(crop.rgb, cut.rgb) << describe(object);
    }
  }
}

TEST(Renderer, ForegroundWearsTheColorSampleOfItsIndex) {
  Renderer renderer;
  const ObjectState near{ObjectType::kEgg, {0, 0}, 0, 2, 2};
  const ObjectState far{ObjectType::kEgg, {2, 4}, 0, 2, 2};
  const RgbdImage frame = renderer.render(worldOf({near, far}), kStandard);
  EXPECT_EQ(renderer.renderForeground(Workbench{}, far, kStandard, 1).rgb,
            cropObject(frame, 2).rgb);
  EXPECT_NE(renderer.renderForeground(Workbench{}, far, kStandard, 0).rgb,
            cropObject(frame, 2).rgb);
}

TEST(Renderer, NearObjectsHideFarOnesAndThrowShadows) {
  Renderer renderer;
  const ObjectState far{ObjectType::kPlate, {1, 3}, 0, 0, 3};
  const ObjectState near{ObjectType::kDyer, {1, 2}, 0, 1, 3};
  const RgbdImage alone = renderer.render(worldOf({far}), kStandard);
  const RgbdImage both = renderer.render(worldOf({far, near}), kStandard);
  EXPECT_LT(count(both, 1), count(alone, 1));
  EXPECT_GT(count(both, 1), 0);

  const RgbdImage empty = renderer.render(worldOf({}), kStandard);
  long darker = 0;
  long lighter = 0;
  for (std::size_t i = 0; i < both.mask.size(); ++i) {
    if (both.mask[i] != 0) continue;
    darker += both.rgb[3 * i + 1] + 12 < empty.rgb[3 * i + 1];
    lighter += both.rgb[3 * i + 1] > empty.rgb[3 * i + 1] + 30;
  }
  EXPECT_GT(darker, 100) << "shadow on the table";
  EXPECT_LT(lighter, 100) << "only blended outlines";
}

TEST(Renderer, TellsTheFourRotationsApartEvenFarAndSmall) {
  Renderer renderer;
  for (int type = 0; type < static_cast<int>(kNumObjectTypes); ++type) {
    std::vector<ObjectCrop> crops;
    for (int rotation = 0; rotation < 4; ++rotation) {
      const ObjectState object{static_cast<ObjectType>(type), {1, 4}, rotation, type % 6, 0};
      crops.push_back(renderer.renderForeground(Workbench{}, object, kStandard));
    }
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a + 1; b < 4; ++b) {
        int clear = 0;
        for (std::size_t i = 0; i < crops[a].mask.size(); ++i) {
          int difference = 0;
          for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            difference = std::max(difference, std::abs(crops[a].rgb[c] - crops[b].rgb[c]));
          }
          clear += difference > 50;
        }
        EXPECT_GT(clear, 0.18 * std::max(area(crops[a]), area(crops[b])))
            << name(static_cast<ObjectType>(type)) << " at " << 90 * a << " and " << 90 * b;
      }
    }
  }
}

TEST(Renderer, ShowsEverySampleOfAColorNearItsHue) {
  Renderer renderer;
  for (int color = 0; color < 6; ++color) {
    for (std::uint64_t seed = 0; seed < kColorSamples; ++seed) {
      const ObjectState object{ObjectType::kEgg, {1, 2}, 0, color, 3};
      const ObjectCrop crop = renderer.renderForeground(Workbench{}, object, {seed});
      // The mean direction of hue over the saturated pixels.
      double along = 0;
      double across = 0;
      for (std::size_t i = 0; i < crop.mask.size(); ++i) {
        if (crop.mask[i] == 0) continue;
        const double r = crop.rgb[3 * i], g = crop.rgb[3 * i + 1], b = crop.rgb[3 * i + 2];
        along += r - 0.5 * (g + b);
        across += std::sqrt(0.75) * (g - b);
      }
      const double hue = std::atan2(across, along) * 180 / M_PI;
      EXPECT_LT(std::abs(std::remainder(hue - 60 * color, 360)), 18)
          << colorName(color) << " sample " << seed;
    }
  }
}

TEST(Renderer, LargerSizesCoverMorePixels) {
  Renderer renderer;
  int last = 0;
  for (int size = 0; size < 4; ++size) {
    const int pixels = area(
        renderer.renderForeground(Workbench{}, {ObjectType::kPot, {1, 2}, 0, 0, size}, kStandard));
    EXPECT_GT(pixels, 1.15 * last);
    last = pixels;
  }
}

TEST(Renderer, TheLargestObjectsFitTheCropNearTheCamera) {
  Renderer renderer;
  for (int type = 0; type < static_cast<int>(kNumObjectTypes); ++type) {
    for (int rotation = 0; rotation < 4; ++rotation) {
      for (const Appearance& appearance : {kStandard, kShifted, Appearance{4, kShifted.domain}}) {
        const ObjectState object{static_cast<ObjectType>(type), {2, 0}, rotation, 0, 3};
        const ObjectCrop crop = renderer.renderForeground(Workbench{}, object, appearance);
        constexpr std::size_t kEdge = ObjectCrop::kEdge;
        for (std::size_t i = 0; i < kEdge; ++i) {
          const int border = crop.mask[i] + crop.mask[(kEdge - 1) * kEdge + i] +
                             crop.mask[i * kEdge] + crop.mask[i * kEdge + kEdge - 1];
          ASSERT_EQ(border, 0) << describe(object);
        }
      }
    }
  }
}

TEST(Renderer, SeedsChangeTheRoom) {
  Renderer renderer;
  const RgbdImage one = renderer.render(worldOf({}), {1});
  const RgbdImage two = renderer.render(worldOf({}), {2});
  EXPECT_NE(one.rgb, two.rgb);
  EXPECT_EQ(one.depth_m, two.depth_m) << "the standard camera stays";
}

TEST(Renderer, ShiftedCamerasStayInTheirRange) {
  const Camera standard = Renderer::camera({});
  double farthest = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    EXPECT_TRUE(Renderer::camera({seed}).X_WC.isApprox(standard.X_WC));
    const Camera shifted = Renderer::camera({seed, RenderDomain::kShifted});
    const Eigen::Vector3d moved = shifted.X_WC.translation() - standard.X_WC.translation();
    farthest = std::max(farthest, moved.cwiseAbs().maxCoeff());
    EXPECT_NEAR(shifted.focal_px / standard.focal_px, 1, 0.022);
  }
  EXPECT_LE(farthest, 0.04);
  EXPECT_GT(farthest, 0.03);
}

TEST(Renderer, ShiftedPicturesAreNoisy) {
  Renderer renderer;
  const auto roughness = [](const RgbdImage& image) {
    double sum = 0;
    for (std::size_t i = 3; i < image.rgb.size(); ++i) {
      sum += std::abs(image.rgb[i] - image.rgb[i - 3]);
    }
    return sum / static_cast<double>(image.rgb.size());
  };
  EXPECT_GT(roughness(renderer.render(worldOf({}), kShifted)), 2);
}

TEST(Renderer, RejectsWhatItCannotDraw) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  Renderer renderer;
  const ObjectState turned{ObjectType::kCup, {0, 0}, 4, 0, 0};
  EXPECT_THAT([&] { renderer.render(worldOf({turned}), kStandard); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("found 4, 0 and 0")));
  EXPECT_THAT([&] { renderer.renderForeground(Workbench{}, turned, kStandard); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("rotation in [0, 4)")));
  EXPECT_THAT([&] { renderer.render(worldOf(std::vector<ObjectState>(256)), kStandard); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("found 256")));
  const ObjectState away{ObjectType::kCup, {40, 2}, 0, 0, 0};
  EXPECT_THAT([&] { renderer.renderForeground(Workbench{}, away, kStandard); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("cell (40, 2) lies outside")));
}

}  // namespace
}  // namespace conceptplan
