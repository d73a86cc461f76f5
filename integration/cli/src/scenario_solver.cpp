#include "scenario_solver.hpp"

#include "scenario_check.hpp"

namespace conceptplan::cli {

SolvedScenario ScenarioSolver::solve(const std::filesystem::path& file, const std::string& planner,
                                     const std::string& model, const SolveOptions& options) {
  SolvedScenario solved;
  solved.scenario = readCheckedScenario(file, registry_);
  solved.planner = planner.empty() ? solved.scenario.planner.name : planner;
  const auto loadModel = [&] {
    solved.model = load(model.empty() ? modelFolder(solved.scenario) : findModel(model));
  };
  if (solved.scenario.targets.empty()) {
    const auto search = makePlanner(solved.scenario, solved.planner, registry_);
    loadModel();
    solved.solution = solveScenario(solved.scenario, *solved.model, *search, options);
  } else {
    const JointPlanner search = makeJointPlanner(solved.scenario, solved.planner, registry_);
    loadModel();
    solved.solution = solveScenario(solved.scenario, *solved.model, search, options);
  }
  return solved;
}

std::shared_ptr<const Model> ScenarioSolver::load(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const Model>& model = models_[folder];
  if (!model) model = std::make_shared<const Model>(folder);
  return model;
}

}  // namespace conceptplan::cli
