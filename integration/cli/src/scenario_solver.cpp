#include "scenario_solver.hpp"

#include "scenario_check.hpp"

namespace conceptplan::cli {

SolvedScenario ScenarioSolver::solve(const std::filesystem::path& file, const std::string& planner,
                                     const std::string& model, const SolveOptions& options) {
  SolvedScenario solved;
  solved.scenario = readCheckedScenario(file, registry_);
  solved.planner = planner.empty() ? solved.scenario.planner.name : planner;
  const auto loadModel = [&] { solved.model = load(solved.scenario, model); };
  if (solved.scenario.targets.empty()) {
    const auto search = makePlanner(solved.scenario, solved.planner, registry_);
    loadModel();
    solved.solution = solveScenario(solved.scenario, *solved.model, *search, options);
  } else {
    const JointPlanner search = makeJointPlanner(solved.scenario, solved.planner, registry_);
    loadModel();
    solved.solution = solveScenario(solved.scenario, *solved.model, search, options);
  }
  solved.solution.legality_threshold =
      legalityThreshold(solved.scenario, solved.planner, registry_);
  return solved;
}

CompiledScenario ScenarioSolver::compile(const std::filesystem::path& file,
                                         const std::string& model) {
  Scenario scenario = readCheckedScenario(file, registry_);
  std::shared_ptr<const Model> loaded = load(scenario, model);
  SymbolGraph graph = compileScenario(scenario, *loaded);
  return {std::move(scenario), std::move(loaded), std::move(graph)};
}

std::shared_ptr<const Model> ScenarioSolver::load(const Scenario& scenario,
                                                  const std::string& model) {
  const std::filesystem::path folder = model.empty() ? modelFolder(scenario) : findModel(model);
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const Model>& loaded = models_[folder];
  if (!loaded) loaded = std::make_shared<const Model>(folder);
  return loaded;
}

}  // namespace conceptplan::cli
