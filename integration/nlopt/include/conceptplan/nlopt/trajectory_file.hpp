#pragma once

#include <filesystem>
#include <string>

#include "conceptplan/nlopt/refiner.hpp"

namespace conceptplan {

/// Version of the JSON.
inline constexpr int kTrajectoryVersion = 1;

/// The motion as one JSON object: `version`, `frame`, `length_m`, `clearance_m`, `fell_back`,
/// `reason`, `duration_s`; `spline` with `degree` 3, `span_s` and `control_points`, each [x_m, y_m,
/// heading_rad, lift_m], from which the motion follows exactly; and `knots`, the points at the ends
/// of its spans, each an object of time_s, x_m, y_m, heading_rad and lift_m.
std::string toJson(const RefinementResult& result);

/// Points at steps of at most `step_s`, with the heading
/// time_s,x_m,y_m,heading_rad,lift_m.
std::string toCsv(const Trajectory& trajectory, double step_s = 0.02);

/// Writes trajectory.json and trajectory.csv, each atomically.
/// @throws as `writeFileAtomically`.
void writeTrajectory(const std::filesystem::path& folder, const RefinementResult& result);

}  // namespace conceptplan
