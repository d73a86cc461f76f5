#include "determinisation_options.hpp"

#include "number_range.hpp"

namespace conceptplan::cli {
namespace {

/// An option of the scenario's planner; its registry has checked that it is a number.
double plannerOption(const Scenario& scenario, const std::string& name, double standard) {
  const auto found = scenario.planner.options.find(name);
  return found == scenario.planner.options.end() ? standard : std::stod(found->second);
}

}  // namespace

void addDeterminisation(CLI::App& command, DeterminisationOptions& options) {
  command
      .add_option("--legality-threshold", options.legality_threshold,
                  "Actions are legal where their probability is greater; that of the scenario's "
                  "planner if left out")
      ->check(inRange(0.0, 1.0))
      ->type_name("P");
  command
      .add_option("--step-discount", options.step_discount,
                  "Share by which a step more must raise the probability; that of the scenario's "
                  "planner if left out")
      ->check(inRange(0.0, 0.5))
      ->type_name("P");
}

Determinisation determinisationOf(const Scenario& scenario, const DeterminisationOptions& options) {
  Determinisation result;
  result.legality_threshold = options.legality_threshold.value_or(
      plannerOption(scenario, "legality_threshold", result.legality_threshold));
  result.step_discount = options.step_discount.value_or(
      plannerOption(scenario, "step_discount", result.step_discount));
  return result;
}

}  // namespace conceptplan::cli
