#pragma once

#include <optional>

#include "command_line.hpp"
#include "conceptplan/domain/scenario/scenario.hpp"
#include "conceptplan/planners/pddl/determinisation.hpp"

namespace conceptplan::cli {

/// What a command may say of how a scenario becomes a problem with most probable outcomes.
struct DeterminisationOptions {
  std::optional<double> legality_threshold;
  std::optional<double> step_discount;
};

/// The options `--legality-threshold` and `--step-discount`.
void addDeterminisation(CLI::App& command, DeterminisationOptions& options);

/// What the command says, else what the scenario's planner is told, else the standard.
Determinisation determinisationOf(const Scenario& scenario, const DeterminisationOptions& options);

}  // namespace conceptplan::cli
