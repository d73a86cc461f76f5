#pragma once

#include <filesystem>
#include <string>

#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// The ground truth of a scenario, for evaluation and for the simulator's frames only. A scenario
/// without a solution has an empty plan and a goal that differs from the start.
struct Reference {
  Task task;
  RenderDomain domain = RenderDomain::kStandard;
};

/// Whether there is a plan that solves the task.
bool hasSolution(const Reference& reference);

/// Reads a reference.yaml; docs/scenario.md describes it.
/// @throws InputError with ALL faults, each with line, column and key.
Reference readReference(const std::filesystem::path& path);

/// Writes it atomically; reading gives an equal task.
/// @throws InputError, std::runtime_error as `writeFileAtomically`.
void writeReference(const std::filesystem::path& path, const Reference& reference);

}  // namespace conceptplan
