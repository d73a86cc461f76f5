#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "conceptplan/domain/scenario/scenario.hpp"
#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan::cli {

/// Reads a scenario and checks also what the file format leaves open: the planner's name and
/// options, the algorithm of the refinement, that the model is there, and the reference.
/// @throws InputError with all faults.
Scenario readCheckedScenario(const std::filesystem::path& path, const PlannerRegistry& registry);

/// The one scenario file that a path stands for. @throws InputError if there is none, or several.
std::filesystem::path findScenario(const std::string& path);

/// The planner of that name, with the scenario's options if the scenario names the same one.
/// @throws InputError with the lines of the keys, or where the command asked for another planner,
/// with its option.
std::unique_ptr<Planner> makePlanner(const Scenario& scenario, const std::string& name,
                                     const PlannerRegistry& registry);

/// The same for a scenario with several targets.
JointPlanner makeJointPlanner(const Scenario& scenario, const std::string& name,
                              const PlannerRegistry& registry);

/// The legality threshold of that planner, with the scenario's options if the scenario names the
/// same one; nothing if the planner has none. @pre `makePlanner` or `makeJointPlanner` makes it
std::optional<double> legalityThreshold(const Scenario& scenario, const std::string& name,
                                        const PlannerRegistry& registry);

/// The folder of the scenario's model. @throws InputError with the line of the key.
std::filesystem::path modelFolder(const Scenario& scenario);

}  // namespace conceptplan::cli
