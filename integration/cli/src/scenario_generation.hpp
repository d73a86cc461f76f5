#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"

namespace conceptplan::cli {

/// Which stand-alone scenarios to make.
struct ScenarioSetOptions {
  TaskOptions tasks;
  RenderDomain domain = RenderDomain::kStandard;
  int count = 1;            ///< >= 1
  int targets = 1;          ///< 1, or from level 2 on 2
  bool infeasible = false;  ///< the target stands in a corner, shut in by two obstacles
  bool symbols_only = false;
  std::string model = "default";                    ///< as written into the scenarios
  SymbolGrounding grounding = standardGrounding();  ///< of the symbols, for `symbols_only`
};

/// "level3-0001" for i = 0 at level 3, "level3x2-0001" with two targets, "infeasible-0001" for
/// scenarios without a solution.
std::string scenarioName(const ScenarioSetOptions& options, int i);

/// The ground truth of scenario i: the task of that number, with a second target if two are wanted,
/// or its infeasible variant at level 2.
Reference drawReference(const ScenarioSetOptions& options, int i);

/// The symbols of an object's true values, found by the names that `standardGrounding` gives them.
/// @throws InputError if the grounding names no symbol so.
GivenSymbols symbolsOf(const ObjectState& object, const SymbolGrounding& grounding);

/// Writes FOLDER/NAME for each scenario, replacing those of the name; the same bytes at any number
/// of jobs.
/// @returns the folders; those finished if `cancel` turned true
std::vector<std::filesystem::path> generateScenarios(
    const std::filesystem::path& folder, const ScenarioSetOptions& options, int jobs,
    const std::function<void(std::size_t done, std::size_t total)>& progress,
    const std::atomic<bool>& cancel);

}  // namespace conceptplan::cli
