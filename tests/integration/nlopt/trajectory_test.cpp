#include "conceptplan/nlopt/trajectory.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Control points that are no line, in each row others.
Trajectory::ControlPoints winding(Eigen::Index count) {
  Trajectory::ControlPoints points(4, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto t = static_cast<double>(i);
    points.col(i) << 0.1 * t, std::sin(t), 0.5 * std::cos(2 * t), 0.01 * t * t;
  }
  return points;
}

/// The derivative by differences, on both sides of the time or on one.
Eigen::Vector4d slope(const Trajectory& trajectory, double from_s, double to_s) {
  const MotionPoint a = trajectory.at(from_s);
  const MotionPoint b = trajectory.at(to_s);
  return Eigen::Vector4d(b.x_m - a.x_m, b.y_m - a.y_m, b.heading_rad - a.heading_rad,
                         b.lift_m - a.lift_m) /
         (to_s - from_s);
}

TEST(Trajectory, StandsStillAtThreeEqualControlPoints) {
  Trajectory::ControlPoints points = winding(6);
  points.leftCols<3>().colwise() = Eigen::Vector4d(1, 2, 3, 4);
  const Trajectory trajectory(points, 0.5);
  EXPECT_EQ(trajectory.numSpans(), 3);
  EXPECT_EQ(trajectory.duration_s(), 1.5);
  const MotionPoint start = trajectory.at(0);
  EXPECT_NEAR(start.x_m, 1, 1e-12);
  EXPECT_NEAR(start.y_m, 2, 1e-12);
  EXPECT_NEAR(start.heading_rad, 3, 1e-12);
  EXPECT_NEAR(start.lift_m, 4, 1e-12);
  EXPECT_NEAR(slope(trajectory, 0, 1e-4).norm(), 0, 1e-6);
}

TEST(Trajectory, VelocityAndAccelerationAreContinuousAtTheKnots) {
  const Trajectory trajectory(winding(9), 0.5);
  constexpr double kStep_s = 1e-5;
  for (int knot = 1; knot < trajectory.numSpans(); ++knot) {
    const double time_s = 0.5 * knot;
    const Eigen::Vector4d before = slope(trajectory, time_s - kStep_s, time_s);
    const Eigen::Vector4d after = slope(trajectory, time_s, time_s + kStep_s);
    EXPECT_NEAR((after - before).norm(), 0, 1e-3);  // acceleration times the step
    constexpr double kWide_s = 1e-3;
    const Eigen::Vector4d bent_before = slope(trajectory, time_s - kWide_s, time_s) -
                                        slope(trajectory, time_s - 2 * kWide_s, time_s - kWide_s);
    const Eigen::Vector4d bent_after = slope(trajectory, time_s + kWide_s, time_s + 2 * kWide_s) -
                                       slope(trajectory, time_s, time_s + kWide_s);
    EXPECT_NEAR((bent_after - bent_before).norm() / kWide_s, 0, 0.2);
  }
}

TEST(Trajectory, EachSpanLiesInTheBoxOfItsControlPoints) {
  const Trajectory trajectory(winding(9), 0.5);
  for (const MotionPoint& point : trajectory.samples(0.01)) {
    const int span = std::min(static_cast<int>(point.time_s / 0.5), trajectory.numSpans() - 1);
    const auto box = trajectory.controlPoints().middleCols<4>(span);
    EXPECT_GE(point.y_m, box.row(1).minCoeff() - 1e-12);
    EXPECT_LE(point.y_m, box.row(1).maxCoeff() + 1e-12);
  }
}

TEST(Trajectory, SamplesAreNoFurtherApartThanAsked) {
  const Trajectory trajectory(winding(9), 0.5);
  const std::vector<MotionPoint> in_time = trajectory.samples(0.4);
  EXPECT_EQ(in_time.size(), 9u);
  EXPECT_EQ(in_time.back(), trajectory.at(3));
  const std::vector<MotionPoint> in_space = trajectory.denseSamples(0.01);
  EXPECT_EQ(in_space.front(), trajectory.at(0));
  EXPECT_EQ(in_space.back(), trajectory.at(3));
  for (std::size_t i = 1; i < in_space.size(); ++i) {
    const MotionPoint& a = in_space[i - 1];
    const MotionPoint& b = in_space[i];
    EXPECT_LE(std::hypot(b.x_m - a.x_m, b.y_m - a.y_m, b.lift_m - a.lift_m), 0.01);
  }
}

TEST(Trajectory, TimesBeyondItsEndsGiveTheEnds) {
  const Trajectory trajectory(winding(5), 1);
  EXPECT_EQ(trajectory.at(-1), trajectory.at(0));
  EXPECT_EQ(trajectory.at(3), trajectory.at(2));
}

TEST(Trajectory, MayBeAPointThatLastsNoTime) {
  Trajectory::ControlPoints points(4, 3);
  points.colwise() = Eigen::Vector4d(1, 2, 0, 0);
  const Trajectory trajectory(points, 1);
  EXPECT_EQ(trajectory.duration_s(), 0);
  EXPECT_EQ(trajectory.at(0), (MotionPoint{0, 1, 2, 0, 0}));
  EXPECT_EQ(trajectory.samples(0.1).size(), 1u);
  EXPECT_EQ(trajectory.denseSamples(0.1).size(), 1u);
}

TEST(Trajectory, RefusesWhatIsNoSpline) {
  EXPECT_THAT([] { Trajectory(Trajectory::ControlPoints(4, 2), 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("2 control points")));
  EXPECT_THAT([] { Trajectory(winding(4), 0); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("span_s is 0")));
}

}  // namespace
}  // namespace conceptplan
