#include "conceptplan/nlopt/motion_task.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "integration/nlopt/motion_worlds.hpp"

namespace conceptplan {
namespace {

constexpr double kQuarter_rad = std::numbers::pi / 2;

Symbols at(int x, int y, int rotation = 0, int color = 0) {
  return {SymbolId{0}, SymbolId{x}, SymbolId{y}, SymbolId{rotation}, SymbolId{color}, SymbolId{3}};
}

SymbolicProblem problemOf(const std::vector<Symbols>& objects) {
  SymbolicProblem problem;
  for (const Symbols& symbols : objects) {
    problem.initial.objects.push_back(certain(symbols, kConceptCardinality));
  }
  return problem;
}

/// One move right, a turn left, a change of colour, a turn right that fails, one move forward.
Plan samplePlan() {
  return {{Action::kMoveRight, Action::kRotateLeft, Action::kChangeColor, Action::kRotateRight,
           Action::kMoveFront},
          1,
          5,
          {at(1, 0), at(1, 0, 1), at(1, 0, 1, 2), at(1, 0, 1, 2), at(1, 1, 1, 2)}};
}

TEST(MotionTask, FollowsThePredictedCellsAndTurns) {
  const MotionTask task =
      motionTaskOf(problemOf({at(0, 0), at(2, 2)}), standardGrounding(), samplePlan());
  ASSERT_EQ(task.waypoints.size(), 6u);
  const std::vector<std::pair<double, double>> places{{-0.2, -0.4}, {0, -0.4}, {0, -0.4},
                                                      {0, -0.4},    {0, -0.4}, {0, -0.2}};
  const std::vector<double> headings{0, 0, kQuarter_rad, kQuarter_rad, kQuarter_rad, kQuarter_rad};
  const std::vector<bool> in_place{false, false, true, true, true, false};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(task.waypoints[i].p_W.x(), places[i].first, 1e-12) << i;
    EXPECT_NEAR(task.waypoints[i].p_W.y(), places[i].second, 1e-12) << i;
    EXPECT_EQ(task.waypoints[i].heading_rad, headings[i]) << i;
    EXPECT_EQ(task.waypoints[i].in_place, in_place[i]) << i;
  }
  ASSERT_EQ(task.obstacles.size(), 1u);
  EXPECT_NEAR(task.obstacles[0].p_WCentre.x(), 0.2, 1e-12);
  EXPECT_EQ(task.waypoints[1].outline, outlineOfDisc(0.08));
}

TEST(MotionTask, TheTargetCoversWhatItTurnsThrough) {
  SymbolGrounding grounding = standardGrounding();
  auto& footprints = grounding.footprints[0][3];
  Outline plank = outlineOfSquare(0.06), across = outlineOfSquare(0.06);
  for (const std::size_t k : {4u, 12u}) plank.support_m[k] = 0.03;
  for (const std::size_t k : {0u, 8u}) across.support_m[k] = 0.03;
  footprints[0].outline = tightened(plank);
  footprints[1].outline = tightened(across);
  const MotionTask task = motionTaskOf(problemOf({at(0, 0), at(2, 2)}), grounding, samplePlan());
  EXPECT_EQ(task.waypoints[0].outline, tightened(plank));
  EXPECT_EQ(task.waypoints[1].outline, tightened(plank));
  EXPECT_EQ(task.waypoints[3].outline, tightened(across));
  EXPECT_EQ(task.waypoints[5].outline, tightened(across));
  // The square around both, without the corners that neither reaches.
  const Outline turning = task.waypoints[2].outline;
  EXPECT_NEAR(turning.support_m[0], 0.06, 1e-12);
  EXPECT_NEAR(turning.support_m[4], 0.06, 1e-12);
  EXPECT_NEAR(turning.support_m[2], std::hypot(0.06, 0.03), 0.012);
  EXPECT_GE(turning.support_m[2], std::hypot(0.06, 0.03));
}

TEST(MotionTask, RefusesAPlanWithoutItsPredictedStates) {
  Plan plan = samplePlan();
  plan.predicted.pop_back();
  EXPECT_THAT([&] { motionTaskOf(problemOf({at(0, 0)}), standardGrounding(), plan); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  ::testing::HasSubstr("5 actions with 4 predicted states")));
}

TEST(MotionTask, TheDiscreteTrajectoryRestsAtEachWaypoint) {
  const MotionTask task =
      motionTaskOf(problemOf({at(0, 0), at(2, 2)}), standardGrounding(), samplePlan());
  const Trajectory trajectory = discreteTrajectory(task, 2);
  EXPECT_DOUBLE_EQ(trajectory.duration_s(), 10);
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    const MotionPoint point = trajectory.at(2.0 * static_cast<double>(i));
    EXPECT_NEAR(point.x_m, task.waypoints[i].p_W.x(), 1e-12);
    EXPECT_NEAR(point.y_m, task.waypoints[i].p_W.y(), 1e-12);
    EXPECT_NEAR(point.heading_rad, task.waypoints[i].heading_rad, 1e-12);
  }
  EXPECT_NEAR(length_m(trajectory), 0.4, 1e-9);
  EXPECT_NEAR(clearance_m(task, trajectory), 0.02, 1e-9);  // to the edge
}

TEST(MotionTask, ClearanceToAnObstacleCountsBesideOrAboveIt) {
  MotionTask task = motionTaskOf(problemOf({at(1, 1), at(1, 2)}), standardGrounding(), {});
  EXPECT_NEAR(clearance_m(task, discreteTrajectory(task, 1)), 0.04, 1e-9);
  Trajectory::ControlPoints above(4, 3);
  above.colwise() = Eigen::Vector4d(0, 0, 0, 0.18);
  EXPECT_NEAR(clearance_m(task, Trajectory(above, 1)), 0.02, 1e-9);  // its height is 0.16
}

TEST(MotionTask, SquaredJerkIsTheIntegral) {
  const MotionTask task = testing::plannedMotion(4, 0);
  const Trajectory trajectory = discreteTrajectory(task, 1.5);
  // Jerk is constant within a span; its third difference over a span is exact.
  double sum = 0;
  const double step_s = trajectory.span_s() / 3;
  for (int span = 0; span < trajectory.numSpans(); ++span) {
    Eigen::Vector3d third = Eigen::Vector3d::Zero();
    for (int k = 0; k < 4; ++k) {
      const MotionPoint point = trajectory.at(span * trajectory.span_s() + k * step_s);
      const double weight = std::array{-1.0, 3.0, -3.0, 1.0}[static_cast<std::size_t>(k)];
      third += weight * Eigen::Vector3d(point.x_m, point.y_m, point.lift_m);
    }
    sum += (third / (step_s * step_s * step_s)).squaredNorm() * trajectory.span_s();
  }
  EXPECT_NEAR(squaredJerk(trajectory), sum, 1e-6 * sum);
}

}  // namespace
}  // namespace conceptplan
