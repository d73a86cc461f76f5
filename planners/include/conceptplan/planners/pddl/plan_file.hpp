#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/domain/action.hpp"

namespace conceptplan {

/// One ground action of a plan file, e.g. "(move_left position_x-1 position_x-0)".
struct PlanFileStep {
  Action action = Action::kMoveFront;
  std::vector<std::string> arguments;  ///< as in the exported PDDL, in lower case; may be left out
  int line = 0;                        ///< in the file, from 1; 0 if made by a program

  bool operator==(const PlanFileStep&) const = default;
};

/// A plan as planners of the International Planning Competition write it: one action a line in
/// parentheses, and the comment "; cost = 20100 (general cost)".
struct PlanFile {
  std::vector<PlanFileStep> steps;
  std::optional<std::int64_t> cost;  ///< as the comment states it, >= 0
  bool unit_cost = false;            ///< every action costs one

  bool operator==(const PlanFile&) const = default;
};

/// Empty lines and other comments are skipped; upper and lower case are one.
/// @param path stands in the faults.
/// @throws InputError with ALL faults, each with line and column: a line that is no action, an
///   unknown action, a cost that is no whole number or is stated twice.
PlanFile parsePlanFile(std::string_view text, const std::filesystem::path& path);

/// @throws InputError as `parsePlanFile`, or that the file cannot be read.
PlanFile readPlanFile(const std::filesystem::path& path);

/// Parsing the text gives an equal plan, but for the lines.
std::string planFileText(const PlanFile& plan);

}  // namespace conceptplan
