#include "conceptplan/nlopt/refiner.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "integration/nlopt/motion_worlds.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

/// The target goes along cells, given as (column, row) of the standard workbench.
MotionTask through(const std::vector<Cell>& cells, double radius_m) {
  MotionTask task;
  for (const Cell cell : cells) {
    const Eigen::Vector2d p_W = task.workbench.p_WCell(cell);
    const bool in_place = !task.waypoints.empty() && task.waypoints.back().p_W == p_W;
    task.waypoints.push_back({p_W, 0, outlineOfDisc(radius_m), in_place});
  }
  task.height_m = 0.1;
  return task;
}

UprightPrism obstacleIn(Cell cell, double radius_m, double height_m = 0.1) {
  return {Workbench{}.p_WCell(cell), outlineOfDisc(radius_m), height_m};
}

TEST(Refiner, RefinedMotionsOfTasksAreClearSmoothAndNoLonger) {
  const RefinementOptions options;
  const Refiner refiner(options);
  for (int level = 2; level <= 4; ++level) {
    for (int i = 0; i < 40; ++i) {
      const MotionTask task = testing::plannedMotion(level, i);
      const RefinementResult result = refiner.refine(task);
      ASSERT_FALSE(result.fell_back) << level << " " << i << ": " << result.reason;
      EXPECT_THAT(result.reason, IsEmpty());
      EXPECT_GE(result.clearance_m, options.clearance_m);
      EXPECT_LE(result.length_m, result.discrete_length_m + 1e-6);
      EXPECT_LE(result.squared_jerk, squaredJerk(discreteTrajectory(task, 1)) * (1 + 1e-9));
      EXPECT_TRUE(testing::isClear(task, result.trajectory, options.clearance_m))
          << level << " " << i;
    }
  }
}

TEST(Refiner, StartGoalAndTimesAreThePlans) {
  RefinementOptions options;
  options.action_s = 2;
  for (int i = 0; i < 10; ++i) {
    const MotionTask task = testing::plannedMotion(4, i);
    const Trajectory trajectory = Refiner(options).refine(task).trajectory;
    const auto actions = static_cast<double>(task.waypoints.size() - 1);
    EXPECT_NEAR(trajectory.duration_s(), 2 * actions, 1e-9);
    for (const bool at_goal : {false, true}) {
      const MotionPoint point = trajectory.at(at_goal ? trajectory.duration_s() : 0);
      const MotionWaypoint& place = at_goal ? task.waypoints.back() : task.waypoints.front();
      EXPECT_NEAR(point.x_m, place.p_W.x(), 1e-12);
      EXPECT_NEAR(point.y_m, place.p_W.y(), 1e-12);
      EXPECT_NEAR(point.heading_rad, place.heading_rad, 1e-12);
      EXPECT_EQ(point.lift_m, 0);
    }
  }
}

TEST(Refiner, StepsInPlaceHappenInTheirCellAndTurnByThePlansTurns) {
  const RefinementOptions options;
  int in_place = 0;
  for (int i = 0; i < 20; ++i) {
    const MotionTask task = testing::plannedMotion(4, i);
    const Trajectory trajectory = Refiner(options).refine(task).trajectory;
    for (std::size_t step = 0; step + 1 < task.waypoints.size(); ++step) {
      const MotionWaypoint& after = task.waypoints[step + 1];
      const auto begin_s = static_cast<double>(step);
      EXPECT_NEAR(trajectory.at(begin_s).heading_rad, task.waypoints[step].heading_rad, 1e-12);
      EXPECT_NEAR(trajectory.at(begin_s + 1).heading_rad, after.heading_rad, 1e-12);
      if (!after.in_place) continue;
      ++in_place;
      for (double time_s = begin_s; time_s <= begin_s + 1; time_s += 0.01) {
        const MotionPoint point = trajectory.at(time_s);
        EXPECT_LE(std::abs(point.x_m - after.p_W.x()), options.cell_reach * 0.2 + 1e-9);
        EXPECT_LE(std::abs(point.y_m - after.p_W.y()), options.cell_reach * 0.2 + 1e-9);
        EXPECT_EQ(point.lift_m, 0);
      }
    }
  }
  EXPECT_GT(in_place, 10);
}

TEST(Refiner, CutsACornerToTheStraightLineWhereNothingStands) {
  const RefinementResult result =
      Refiner().refine(through({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, 0.05));
  EXPECT_NEAR(result.discrete_length_m, 0.8, 1e-9);
  EXPECT_NEAR(result.length_m, std::hypot(0.4, 0.4), 0.002);
}

TEST(Refiner, GoesRoundAnObstacleOnTheShortestWay) {
  MotionTask task = through({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, 0.05);
  task.obstacles = {obstacleIn({1, 1}, 0.05)};
  const RefinementResult result = Refiner().refine(task);
  ASSERT_FALSE(result.fell_back) << result.reason;
  // Two tangents to the disc of both radii and the clearance, and the arc between them.
  const double radius_m = 0.11;
  const double far_m = std::hypot(0.2, 0.2);
  const double arc_rad = std::numbers::pi - 2 * std::acos(radius_m / far_m);
  const double shortest_m = 2 * std::sqrt(far_m * far_m - radius_m * radius_m) + radius_m * arc_rad;
  EXPECT_GE(result.length_m, shortest_m - 1e-6);
  EXPECT_LE(result.length_m, shortest_m + 0.01);
  EXPECT_LT(result.clearance_m, 0.013);
}

TEST(Refiner, LiftsTheTargetOverWhatItCannotPass) {
  // Too little room between the obstacle in the middle and the way along the left column.
  MotionTask task = through({{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}}, 0.05);
  task.obstacles = {obstacleIn({1, 2}, 0.16, 0.08)};
  const RefinementResult result = Refiner().refine(task);
  ASSERT_FALSE(result.fell_back) << result.reason;
  EXPECT_LT(result.discrete_clearance_m, 0.01);
  EXPECT_GT(result.lift_m, 0.08);
  EXPECT_GE(result.clearance_m, 0.01);
  EXPECT_TRUE(testing::isClear(task, result.trajectory, 0.01));
  RefinementOptions never;
  never.max_lift_m = 0;
  const RefinementResult pushed = Refiner(never).refine(task);
  EXPECT_TRUE(pushed.fell_back);
  EXPECT_THAT(pushed.reason, HasSubstr("pushed, the motion keeps"));
}

TEST(Refiner, FallsBackToTheDiscretePlanAndSaysWhy) {
  MotionTask task = through({{1, 0}, {1, 1}, {1, 2}}, 0.085);
  task.obstacles = {obstacleIn({0, 0}, 0.11)};
  const RefinementResult beside = Refiner().refine(task);
  EXPECT_TRUE(beside.fell_back);
  EXPECT_EQ(beside.reason, "the start is 5.0 mm from obstacle 1, 10.0 mm are asked");
  EXPECT_EQ(beside.trajectory, discreteTrajectory(task, 1));
  EXPECT_NEAR(beside.length_m, 0.4, 1e-9);
  EXPECT_NEAR(beside.clearance_m, 0.005, 1e-6);

  RefinementOptions wide;
  wide.clearance_m = 0.02;
  const RefinementResult edge = Refiner(wide).refine(through({{0, 0}, {0, 1}}, 0.09));
  EXPECT_TRUE(edge.fell_back);
  EXPECT_EQ(edge.reason, "the start is 10.0 mm from the workbench's edge, 20.0 mm are asked");
}

TEST(Refiner, AnswersPlansThatLeaveNothingToChoose) {
  const RefinementResult nothing = Refiner().refine(through({{1, 1}}, 0.05));
  EXPECT_FALSE(nothing.fell_back);
  EXPECT_EQ(nothing.trajectory.duration_s(), 0);
  EXPECT_EQ(nothing.length_m, 0);
  const RefinementResult one_move = Refiner().refine(through({{1, 1}, {1, 2}}, 0.05));
  EXPECT_FALSE(one_move.fell_back);
  EXPECT_NEAR(one_move.length_m, 0.2, 1e-9);
  const RefinementResult in_place = Refiner().refine(through({{1, 1}, {1, 1}, {1, 1}}, 0.05));
  EXPECT_FALSE(in_place.fell_back);
  EXPECT_NEAR(in_place.length_m, 0, 1e-9);
}

TEST(Refiner, EveryAlgorithmFindsAMotionAsGood) {
  MotionTask task = through({{0, 0}, {1, 0}, {2, 0}, {2, 1}}, 0.06);
  task.obstacles = {obstacleIn({1, 1}, 0.08)};
  const double best_m = Refiner().refine(task).length_m;
  for (const RefinementAlgorithm& algorithm : refinementAlgorithms()) {
    RefinementOptions options;
    options.algorithm = algorithm.name;
    options.max_evaluations = 4000;
    const RefinementResult result = Refiner(options).refine(task);
    EXPECT_FALSE(result.fell_back) << algorithm.name << ": " << result.reason;
    EXPECT_LE(result.length_m, result.discrete_length_m) << algorithm.name;
    EXPECT_NEAR(result.length_m, best_m, 0.02) << algorithm.name;
    EXPECT_THAT(algorithm.source, ::testing::Not(IsEmpty()));
  }
}

TEST(Refiner, ThreadsGiveTheSameMotions) {
  const Refiner refiner;
  const MotionTask task = testing::plannedMotion(4, 1);
  const Trajectory alone = refiner.refine(task).trajectory;
  std::vector<std::future<RefinementResult>> results;
  for (int i = 0; i < 4; ++i) {
    results.push_back(std::async(std::launch::async, [&] { return refiner.refine(task); }));
  }
  for (auto& result : results) EXPECT_EQ(result.get().trajectory, alone);
}

/// That the answer is the plan as it was, for the reason given, and that the solver hardly ran.
void expectCutShort(const RefinementOptions& options, const std::string& reason) {
  const MotionTask task = testing::plannedMotion(4, 1);
  const RefinementResult result = Refiner(options).refine(task);
  EXPECT_TRUE(result.fell_back);
  EXPECT_EQ(result.reason, reason);
  EXPECT_EQ(result.trajectory, discreteTrajectory(task, options.action_s));
  EXPECT_EQ(result.length_m, result.discrete_length_m);
  EXPECT_LE(result.evaluations, 1);
}

TEST(Refiner, FallsBackOnceTheTimeIsUpOrItIsCancelled) {
  RefinementOptions options;
  options.timeout_s = 1e-9;
  expectCutShort(options, "stopped at the time limit of 0.000000 s");
  options = {};
  const std::atomic<bool> cancel{true};
  options.cancel = &cancel;
  expectCutShort(options, "cancelled");
  const std::atomic<bool> not_cancelled{false};
  options.cancel = &not_cancelled;
  options.timeout_s = 600;
  EXPECT_FALSE(Refiner(options).refine(testing::plannedMotion(4, 1)).fell_back);
}

TEST(Refiner, RefusesOptionsOutOfRange) {
  const auto with = [](auto change) {
    return [change] {
      RefinementOptions options;
      change(options);
      Refiner refiner(options);
    };
  };
  const auto throws = [](const char* what) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(what));
  };
  EXPECT_THAT(with([](auto& o) { o.clearance_m = 2; }), throws("clearance_m is 2"));
  EXPECT_THAT(with([](auto& o) { o.algorithm = "newton"; }), throws("algorithm is newton"));
  EXPECT_THAT(with([](auto& o) { o.action_s = 0; }), throws("action_s is 0"));
  EXPECT_THAT(with([](auto& o) { o.jerk_weight = -1; }), throws("jerk_weight is -1"));
  EXPECT_THAT(with([](auto& o) { o.cell_reach = 0.5; }), throws("cell_reach is 0.5"));
  EXPECT_THAT(with([](auto& o) { o.max_lift_m = -1; }), throws("max_lift_m is -1"));
  EXPECT_THAT(with([](auto& o) { o.max_evaluations = 0; }), throws("max_evaluations is 0"));
  EXPECT_THAT(with([](auto& o) { o.timeout_s = 0; }), throws("timeout_s is 0"));
}

TEST(Refiner, RefusesAMotionWithoutMeasures) {
  EXPECT_THAT([] { Refiner().refine({}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("without a waypoint")));
  MotionTask task = through({{1, 1}, {1, 2}}, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT([&] { Refiner().refine(task); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("has no measure")));
}

}  // namespace
}  // namespace conceptplan
