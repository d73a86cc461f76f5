#include "conceptplan/fcl/fcl_scene.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <future>
#include <limits>
#include <random>
#include <stdexcept>

#include "conceptplan/fcl/prism_contact.hpp"

namespace conceptplan {
namespace {

constexpr double kMargin_m = 0.01;

/// A workbench of 6 x 6 m with prisms anywhere on it.
class Clutter {
 public:
  explicit Clutter(std::uint64_t seed) : random_(seed) {}

  double draw(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  Eigen::Vector2d point() { return {draw(-2.5, 2.5), draw(-2.5, 2.5)}; }
  UprightPrism prism() {
    Outline outline;
    const double size_m = draw(0.02, 0.3);
    for (double& support_m : outline.support_m) support_m = size_m * draw(0.3, 1);
    return {point(), tightened(outline), draw(0.01, 0.5)};
  }
  std::vector<UprightPrism> prisms(int count) {
    std::vector<UprightPrism> all;
    for (int i = 0; i < count; ++i) all.push_back(prism());
    return all;
  }

 private:
  std::mt19937_64 random_;
};

constexpr Workbench kWide{30, 30, 0.2};

TEST(FclScene, FindsWhatTheDistanceOfOutlinesFinds) {
  Clutter clutter(1);
  for (int scene_number = 0; scene_number < 40; ++scene_number) {
    const std::vector<UprightPrism> others = clutter.prisms(25);
    const FclScene scene(kWide, others, kMargin_m);
    for (int i = 0; i < 100; ++i) {
      const UprightPrism target = clutter.prism();
      const Eigen::Vector2d p_WTo = clutter.point();
      const Verdict motion = scene.checkMotion(target, p_WTo);
      double nearest_m = std::min(edgeClearance_m(kWide, target),
                                  edgeClearance_m(kWide, {p_WTo, target.outline, 1}));
      std::size_t first_met = others.size();
      for (std::size_t k = others.size(); k-- > 0;) {
        const double distance_m = clearanceAlong_m(target, p_WTo, others[k]);
        if (distance_m <= kMargin_m + kContactTolerance_m) first_met = k;
        nearest_m = std::min(nearest_m, distance_m);
      }
      ASSERT_EQ(motion.valid(), first_met == others.size());
      if (motion.valid()) {
        EXPECT_EQ(motion.clearance_m, nearest_m);
      } else {
        ASSERT_EQ(motion.cause, Invalidity::kCollision);
        EXPECT_EQ(motion.object, first_met);
      }
    }
  }
}

TEST(FclScene, AMotionIsAsClearAsItsPoses) {
  Clutter clutter(2);
  for (int i = 0; i < 200; ++i) {
    const FclScene scene(kWide, clutter.prisms(10), kMargin_m);
    UprightPrism target = clutter.prism();
    const Eigen::Vector2d p_WFrom = target.p_WCentre;
    const Eigen::Vector2d p_WTo = clutter.point();
    const Verdict motion = scene.checkMotion(target, p_WTo);
    bool all_valid = true;
    for (int step = 0; step <= 100; ++step) {
      target.p_WCentre = p_WFrom + 0.01 * step * (p_WTo - p_WFrom);
      const Verdict pose = scene.check(target);
      all_valid = all_valid && pose.valid();
      if (motion.valid()) {
        EXPECT_GE(pose.clearance_m, motion.clearance_m - 1e-9);
      }
    }
    EXPECT_TRUE(all_valid || !motion.valid());
  }
}

TEST(FclScene, NamesWhatKeepsItFromAnAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Outline disc = outlineOfDisc(0.1);
  const UprightPrism sound{{0, 0}, disc, 0.1};
  const FclScene unmeasured(kWide, {{{1, 1}, disc, 0.1}, {{2, 2}, outlineOfDisc(nan), 0.1}},
                            kMargin_m);
  EXPECT_EQ(unmeasured.check(sound), (Verdict{Invalidity::kCheckFailed, 1, 0}));
  const FclScene scene(kWide, {{{1, 1}, disc, 0.1}}, kMargin_m);
  EXPECT_EQ(scene.check({{nan, 0}, disc, 0.1}).cause, Invalidity::kCheckFailed);
  EXPECT_EQ(scene.checkMotion(sound, {nan, 0}).cause, Invalidity::kCheckFailed);
  EXPECT_TRUE(scene.checkMotion(sound, {0.5, 0}).valid());
  EXPECT_TRUE(FclScene(kWide, {}, kMargin_m).check(sound).valid());
}

TEST(FclScene, ThreadsMayShareOne) {
  Clutter clutter(3);
  const FclScene scene(kWide, clutter.prisms(50), kMargin_m);
  const std::vector<UprightPrism> targets = clutter.prisms(200);
  const auto all = [&] {
    std::vector<Verdict> verdicts;
    for (const UprightPrism& target : targets) {
      verdicts.push_back(scene.checkMotion(target, {0, 0}));
    }
    return verdicts;
  };
  const std::vector<Verdict> alone = all();
  std::vector<std::future<std::vector<Verdict>>> results;
  for (int i = 0; i < 4; ++i) results.push_back(std::async(std::launch::async, all));
  for (auto& result : results) EXPECT_EQ(result.get(), alone);
}

TEST(FclScene, RefusesAMarginOfNothing) {
  EXPECT_THAT([] { FclScene(kWide, {}, 0); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("margin_m")));
}

TEST(PrismContact, NamesHowBodiesStandToEachOther) {
  const Outline disc = outlineOfDisc(0.1);
  const UprightPrism a{{0, 0}, disc, 0.2};
  const auto beside = [&](double gap_m) { return UprightPrism{{0.2 + gap_m, 0}, disc, 0.3}; };
  EXPECT_EQ(contactOf(a, beside(0.02), 0.01), Contact::kApart);
  EXPECT_EQ(contactOf(a, beside(0.01), 0.01), Contact::kTouching);
  EXPECT_EQ(contactOf(a, beside(0.005), 0.01), Contact::kOverlapping);
  EXPECT_EQ(contactOf(a, a, 0.01), Contact::kOverlapping);
  EXPECT_EQ(contactOf(a, {{0.3, 0}, outlineOfDisc(0), 0.1}, 0.01), Contact::kUndecided);
  EXPECT_EQ(name(Contact::kApart), "apart");
  EXPECT_EQ(name(Contact::kTouching), "touching");
  EXPECT_EQ(name(Contact::kOverlapping), "overlapping");
  EXPECT_EQ(name(Contact::kUndecided), "undecided");
}

TEST(PrismContact, SweepsTheWholeWay) {
  const UprightPrism a{{-1, -1}, outlineOfDisc(0.1), 0.2};
  const UprightPrism b{{0, 0}, outlineOfDisc(0.1), 0.2};
  EXPECT_EQ(sweptContactOf(a, {1, 1}, b, 0.01), Contact::kOverlapping);
  EXPECT_EQ(sweptContactOf(a, {1, -1}, b, 0.01), Contact::kApart);
  EXPECT_EQ(sweptContactOf(a, {-0.2, -0.2}, b, 0.01), Contact::kApart);
  EXPECT_EQ(sweptContactOf(a, {-0.1, -0.1}, b, 0.01), Contact::kOverlapping);
}

}  // namespace
}  // namespace conceptplan
