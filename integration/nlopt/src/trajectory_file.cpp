#include "conceptplan/nlopt/trajectory_file.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/atomic_file.hpp"

namespace conceptplan {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFrame =
    "origin at the centre of the workbench's top, x to the right, y away from the camera, z up";

Json toJsonPoint(const MotionPoint& point) {
  return {{"time_s", point.time_s},
          {"x_m", point.x_m},
          {"y_m", point.y_m},
          {"heading_rad", point.heading_rad},
          {"lift_m", point.lift_m}};
}

}  // namespace

std::string toJson(const RefinementResult& result) {
  const Trajectory& trajectory = result.trajectory;
  Json control_points = Json::array();
  for (const auto& point : trajectory.controlPoints().colwise()) {
    control_points.push_back({point[0], point[1], point[2], point[3]});
  }
  Json knots = Json::array();
  for (int i = 0; i <= trajectory.numSpans(); ++i) {
    knots.push_back(toJsonPoint(trajectory.at(i * trajectory.span_s())));
  }
  const Json json{{"version", kTrajectoryVersion},
                  {"frame", kFrame},
                  {"length_m", result.length_m},
                  {"clearance_m", result.clearance_m},
                  {"fell_back", result.fell_back},
                  {"reason", result.reason},
                  {"duration_s", trajectory.duration_s()},
                  {"spline",
                   {{"degree", 3},
                    {"span_s", trajectory.span_s()},
                    {"control_points", std::move(control_points)}}},
                  {"knots", std::move(knots)}};
  return json.dump(2) + "\n";
}

std::string toCsv(const Trajectory& trajectory, double step_s) {
  std::string text = "time_s,x_m,y_m,heading_rad,lift_m\n";
  for (const MotionPoint& point : trajectory.samples(step_s)) {
    char line[160];
    std::snprintf(line, sizeof line, "%.6f,%.6f,%.6f,%.6f,%.6f\n", point.time_s, point.x_m,
                  point.y_m, point.heading_rad, point.lift_m);
    text += line;
  }
  return text;
}

void writeTrajectory(const std::filesystem::path& folder, const RefinementResult& result) {
  writeFileAtomically(folder / "trajectory.json", toJson(result));
  writeFileAtomically(folder / "trajectory.csv", toCsv(result.trajectory));
}

}  // namespace conceptplan
