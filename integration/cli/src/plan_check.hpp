#pragma once

#include <filesystem>
#include <string>

#include "determinisation_options.hpp"

namespace conceptplan::cli {

/// Replays a plan file on a scenario and tells what came of it. Exits with 0 if the plan is right,
/// with 1 if it fails.
/// @param model in place of the scenario's own; empty: the scenario's
/// @throws InputError with all faults of the plan file, or of the scenario.
int checkPlan(const std::filesystem::path& plan_file, const std::string& scenario,
              const std::string& model, const DeterminisationOptions& options, Session& session);

}  // namespace conceptplan::cli
