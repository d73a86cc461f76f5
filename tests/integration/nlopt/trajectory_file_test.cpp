#include "conceptplan/nlopt/trajectory_file.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "domain/files/temporary_folder.hpp"
#include "integration/nlopt/motion_worlds.hpp"

namespace conceptplan {
namespace {

TEST(TrajectoryFile, JsonHoldsAllThatTheMotionFollowsFrom) {
  const RefinementResult result = Refiner().refine(testing::plannedMotion(4, 2));
  const auto json = nlohmann::json::parse(toJson(result));
  EXPECT_EQ(json["version"], kTrajectoryVersion);
  EXPECT_EQ(json["length_m"], result.length_m);
  EXPECT_EQ(json["clearance_m"], result.clearance_m);
  EXPECT_EQ(json["fell_back"], result.fell_back);
  EXPECT_EQ(json["reason"], result.reason);
  EXPECT_EQ(json["duration_s"], result.trajectory.duration_s());
  const auto& spline = json["spline"];
  EXPECT_EQ(spline["degree"], 3);
  Trajectory::ControlPoints points(4, static_cast<Eigen::Index>(spline["control_points"].size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index row = 0; row < 4; ++row) {
      points(row, i) =
          spline["control_points"][static_cast<std::size_t>(i)][static_cast<std::size_t>(row)];
    }
  }
  const Trajectory read(points, spline["span_s"]);
  EXPECT_EQ(read, result.trajectory);
  ASSERT_EQ(json["knots"].size(), static_cast<std::size_t>(read.numSpans()) + 1);
  EXPECT_EQ(json["knots"].back()["time_s"], read.duration_s());
  EXPECT_EQ(json["knots"].back()["x_m"], read.at(read.duration_s()).x_m);
}

TEST(TrajectoryFile, CsvHasALineAStepOfTime) {
  const Trajectory trajectory = Refiner().refine(testing::plannedMotion(2, 1)).trajectory;
  std::istringstream lines(toCsv(trajectory, 0.1));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time_s,x_m,y_m,heading_rad,lift_m");
  std::size_t count = 0;
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 4);
    ++count;
  }
  EXPECT_EQ(count, trajectory.samples(0.1).size());
}

TEST(TrajectoryFile, WritesBothFiles) {
  const TemporaryFolder folder;
  const RefinementResult result = Refiner().refine(testing::plannedMotion(3, 0));
  writeTrajectory(folder.path(), result);
  EXPECT_EQ(readFile(folder.path() / "trajectory.json"), toJson(result));
  EXPECT_EQ(readFile(folder.path() / "trajectory.csv"), toCsv(result.trajectory));
  EXPECT_THROW(writeTrajectory(folder.path() / "missing", result), InputError);
}

}  // namespace
}  // namespace conceptplan
