#pragma once

#include <filesystem>
#include <memory>

#include "conceptplan/domain/scenario/scenario.hpp"
#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan::cli {

/// Reads a scenario and checks also what the file format leaves open: the planner's name and
/// options, and the reference.
/// @throws InputError with all faults.
Scenario readCheckedScenario(const std::filesystem::path& path, const PlannerRegistry& registry);

/// The planner that a scenario asks for. @throws InputError with the lines of the keys.
std::unique_ptr<Planner> makePlanner(const Scenario& scenario, const PlannerRegistry& registry);

}  // namespace conceptplan::cli
