#include "commands.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "conceptplan/pipeline/all_planners.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "exit_code.hpp"
#include "plan_check.hpp"
#include "scenario_check.hpp"

namespace conceptplan::cli {
namespace {

struct ValidateOptions {
  std::vector<std::string> paths;
  std::string plan;
  std::string model;
  DeterminisationOptions determinisation;
};

/// That the files of the scenario's model are whole, and symbols given by hand are its own.
void checkModel(const Scenario& scenario) {
  const std::filesystem::path folder = modelFolder(scenario);
  readModelManifest(folder);
  if (std::holds_alternative<SymbolInput>(scenario.input)) {
    const ConceptCardinality cardinality =
        readSymbolicModel(folder / kTransitionsFile).cardinality();
    if (scenario.targets.empty()) {
      problemOf(scenario, cardinality);
    } else {
      jointProblemOf(scenario, cardinality);
    }
  }
}

/// All faults that stand in the way of one scenario.
std::vector<Fault> faultsOf(const std::filesystem::path& file, const PlannerRegistry& registry) {
  try {
    checkModel(readCheckedScenario(file, registry));
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

int validate(const ValidateOptions& options, Session& session) {
  if (!options.plan.empty()) {
    if (options.paths.size() > 1) {
      throw InputError({Fault{"--plan", {}, {}, "", "a plan is checked against one scenario"}});
    }
    return checkPlan(options.plan, options.paths.front(), options.model, options.determinisation,
                     session);
  }
  const PlannerRegistry registry = allPlanners();
  Json scenarios = Json::array();
  bool all_valid = true;
  const auto report = [&](const std::string& path, const std::vector<Fault>& faults) {
    all_valid = all_valid && faults.empty();
    scenarios.push_back({{"path", path}, {"ok", faults.empty()}, {"faults", toJson(faults)}});
    if (faults.empty()) session.console.print(path + ": valid");
    for (const Fault& fault : faults) session.console.error("conceptplan: " + fault.text());
  };
  for (const std::string& path : options.paths) {
    std::vector<std::filesystem::path> files;
    try {
      files = findScenarios(path);
    } catch (const InputError& error) {
      report(path, error.faults());
    }
    for (const std::filesystem::path& file : files) {
      report(file.string(), faultsOf(file, registry));
    }
  }
  session.console.printJson({{"ok", all_valid}, {"scenarios", scenarios}});
  return all_valid ? kDone : kWrongInput;
}

}  // namespace

void addValidateCommand(CommandLine& line) {
  const auto options = makeOptions<ValidateOptions>();
  CLI::App& command = line.add(
      "validate", "Report every fault of scenarios, with file, line and column; or check a plan",
      "conceptplan validate scenarios/level3-0001\n"
      "  conceptplan validate --plan sas_plan scenarios/level3-0001",
      [options](Session& session) { return validate(*options, session); });
  command.add_option("SCENARIO", options->paths, "Scenario files, folders, or folders of folders")
      ->required();
  CLI::Option* const plan =
      command
          .add_option("--plan", options->plan,
                      "Replay this plan file on the scenario; tells its cost, or the step at which "
                      "it fails and why")
          ->type_name("FILE");
  command
      .add_option("--model", options->model, "With --plan: a model in place of the scenario's own")
      ->needs(plan)
      ->type_name("NAME|DIR");
  addDeterminisation(command, options->determinisation);
  for (const char* option : {"--legality-threshold", "--step-discount"}) {
    command.get_option(option)->needs(plan);
  }
}

}  // namespace conceptplan::cli
