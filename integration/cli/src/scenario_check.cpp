#include "scenario_check.hpp"

#include "conceptplan/domain/scenario/scenario_file.hpp"

namespace conceptplan::cli {

std::unique_ptr<Planner> makePlanner(const Scenario& scenario, const PlannerRegistry& registry) {
  try {
    return registry.make(scenario.planner.name, scenario.planner.options, scenario.file.string());
  } catch (const InputError& error) {
    std::vector<Fault> placed;
    for (const Fault& fault : error.faults()) {
      placed.push_back(scenario.fault(fault.key, fault.message));
    }
    throw InputError(std::move(placed));
  }
}

Scenario readCheckedScenario(const std::filesystem::path& path, const PlannerRegistry& registry) {
  Scenario scenario = readScenario(path);
  std::vector<Fault> faults;
  const auto collect = [&faults](const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  };
  try {
    makePlanner(scenario, registry);
  } catch (const InputError& error) {
    collect(error);
  }
  try {
    if (scenario.reference) readReference(*scenario.reference);
  } catch (const InputError& error) {
    collect(error);
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return scenario;
}

}  // namespace conceptplan::cli
