#pragma once

#include <filesystem>
#include <vector>

#include "conceptplan/domain/scenario/reference.hpp"
#include "conceptplan/domain/scenario/scenario.hpp"

namespace conceptplan {

/// Reads a scenario and its pictures; docs/scenario.md describes the format. The names of the
/// planner and its options are left for the caller to check, with `Scenario::fault`.
/// @param path the scenario.yaml, or the folder that holds it
/// @throws InputError with ALL faults, each with line, column and key: malformed YAML, unknown or
///   repeated keys, wrong types, values out of range, missing or damaged pictures, a mask that does
///   not fit, a target that is not in the masks.
Scenario readScenario(const std::filesystem::path& path);

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
