#include "scenario_check.hpp"

#include <algorithm>
#include <functional>

#include "conceptplan/domain/files/nearest_name.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "conceptplan/nlopt/refiner.hpp"
#include "conceptplan/pipeline/model.hpp"

namespace conceptplan::cli {
namespace {

/// Where a planner stands that is not the scenario's own.
constexpr const char* kPlannerOption = "--planner";

/// Does the work; its faults become faults of the scenario, at their keys.
template <typename Work>
auto placed(const Scenario& scenario, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<Fault> faults;
    for (const Fault& fault : error.faults()) {
      faults.push_back(scenario.fault(fault.key, fault.message));
    }
    throw InputError(std::move(faults));
  }
}

/// That the refiner has the algorithm which the scenario names.
void checkAlgorithm(const Scenario& scenario) {
  if (!scenario.refine || !scenario.refine->algorithm) return;
  const std::string& name = *scenario.refine->algorithm;
  std::vector<std::string_view> known;
  std::string all;
  for (const RefinementAlgorithm& algorithm : refinementAlgorithms()) {
    known.push_back(algorithm.name);
    all += (all.empty() ? "" : " | ") + std::string(algorithm.name);
  }
  if (std::ranges::find(known, name) != known.end()) return;
  throw InputError({scenario.fault("refine.algorithm", "expected one of " + all + ", found \"" +
                                                           name + "\"" + didYouMean(name, known))});
}

std::vector<Fault> openFaults(const Scenario& scenario, const PlannerRegistry& registry) {
  const std::vector<std::function<void()>> checks{
      [&] { modelFolder(scenario); },
      [&] {
        if (scenario.targets.empty()) {
          makePlanner(scenario, scenario.planner.name, registry);
        } else {
          makeJointPlanner(scenario, scenario.planner.name, registry);
        }
      },
      [&] { checkAlgorithm(scenario); },
      [&] {
        if (scenario.reference && std::filesystem::is_regular_file(*scenario.reference)) {
          readReference(*scenario.reference);
        }
      }};
  std::vector<Fault> faults;
  for (const std::function<void()>& check : checks) {
    try {
      check();
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  return faults;
}

}  // namespace

Scenario readCheckedScenario(const std::filesystem::path& path, const PlannerRegistry& registry) {
  return readScenario(
      path, [&registry](const Scenario& scenario) { return openFaults(scenario, registry); });
}

std::filesystem::path findScenario(const std::string& path) {
  const std::vector<std::filesystem::path> files = findScenarios(path);
  if (files.size() == 1) return files.front();
  throw InputError({Fault{path,
                          {},
                          {},
                          "",
                          "expected one scenario, found " + std::to_string(files.size()) +
                              "; conceptplan solve takes any number"}});
}

std::unique_ptr<Planner> makePlanner(const Scenario& scenario, const std::string& name,
                                     const PlannerRegistry& registry) {
  if (name != scenario.planner.name) return registry.make(name, {}, kPlannerOption);
  return placed(scenario, [&] {
    return registry.make(name, scenario.planner.options, scenario.file.string());
  });
}

JointPlanner makeJointPlanner(const Scenario& scenario, const std::string& name,
                              const PlannerRegistry& registry) {
  if (name != scenario.planner.name) return registry.makeJoint(name, {}, kPlannerOption);
  return placed(scenario, [&] {
    return registry.makeJoint(name, scenario.planner.options, scenario.file.string());
  });
}

std::optional<double> legalityThreshold(const Scenario& scenario, const std::string& name,
                                        const PlannerRegistry& registry) {
  static const std::string kOption = PlannerOption::legalityThreshold().name;
  const PlannerEntry* entry = registry.find(name);
  if (entry == nullptr) return std::nullopt;
  const bool has_one = std::ranges::any_of(
      entry->options, [](const PlannerOption& option) { return option.name == kOption; });
  if (!has_one) return std::nullopt;
  const OptionTexts texts =
      name == scenario.planner.name ? scenario.planner.options : OptionTexts{};
  return OptionValues(entry->options, texts, scenario.file.string()).number(kOption);
}

std::filesystem::path modelFolder(const Scenario& scenario) {
  try {
    return findModel(scenario.model, scenario.file.parent_path());
  } catch (const InputError& error) {
    throw InputError({scenario.fault("model", error.faults().front().message)});
  }
}

}  // namespace conceptplan::cli
