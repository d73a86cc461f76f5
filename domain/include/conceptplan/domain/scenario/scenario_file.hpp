#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "conceptplan/domain/scenario/reference.hpp"
#include "conceptplan/domain/scenario/scenario.hpp"

namespace conceptplan {

/// What the format leaves open, such as the planner's name, checked by the caller: returns the
/// faults, made with `Scenario::fault`. Keys that have a fault already hold their defaults.
using ScenarioCheck = std::function<std::vector<Fault>(const Scenario&)>;

/// Reads a scenario and its pictures; docs/scenario.md describes the format.
/// @param path the scenario.yaml, or the folder that holds it
/// @param check is asked before faults are thrown, so that all come together; may be empty
/// @throws InputError with ALL faults by line, each with line, column and key: malformed YAML,
///   unknown or repeated keys, wrong types, values out of range, missing or damaged pictures, a
///   mask that does not fit, a target that is not in the masks; and those of the check.
Scenario readScenario(const std::filesystem::path& path, const ScenarioCheck& check = {});

/// Writes FOLDER/scenario.yaml, FOLDER/{initial,goal}.{rgb,depth,mask}.png if the task is shown in
/// pictures, and FOLDER/reference.yaml if there is one; the scenario file comes last, so a folder
/// with a scenario file is whole. `file`, `reference` and `positions` of the scenario are ignored.
/// @throws InputError, std::runtime_error as `writeFileAtomically`.
void writeScenario(const std::filesystem::path& folder, const Scenario& scenario,
                   const std::optional<Reference>& reference);

/// The scenario files that a path of the command stands for: the file itself, the file in the
/// folder, or those in the folder's sub-folders, by name.
/// @throws InputError if there is none.
std::vector<std::filesystem::path> findScenarios(const std::filesystem::path& path);

}  // namespace conceptplan
