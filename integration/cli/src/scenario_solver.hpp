#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "conceptplan/pipeline/all_planners.hpp"
#include "conceptplan/pipeline/solve.hpp"

namespace conceptplan::cli {

/// A scenario with all that came of it.
struct SolvedScenario {
  Scenario scenario;
  std::string planner;
  std::shared_ptr<const Model> model;
  Solution solution;
};

/// A scenario with the graph that planners search.
struct CompiledScenario {
  Scenario scenario;
  std::shared_ptr<const Model> model;
  SymbolGraph graph;
};

/// Reads and solves scenarios; a model that several of them name is loaded once. Thread-safe.
class ScenarioSolver {
 public:
  ScenarioSolver() : registry_(allPlanners()) {}

  /// @param planner in place of the scenario's own; empty: the scenario's
  /// @param model in place of the scenario's own; empty: the scenario's
  /// @throws InputError if the scenario or its model is wrong.
  SolvedScenario solve(const std::filesystem::path& file, const std::string& planner,
                       const std::string& model, const SolveOptions& options);

  /// @param model as of `solve` @throws InputError as `solve`.
  CompiledScenario compile(const std::filesystem::path& file, const std::string& model);

  const PlannerRegistry& registry() const { return registry_; }

 private:
  /// @param model in place of the scenario's own; empty: the scenario's
  std::shared_ptr<const Model> load(const Scenario& scenario, const std::string& model);

  PlannerRegistry registry_;
  std::mutex mutex_;
  std::map<std::filesystem::path, std::shared_ptr<const Model>> models_;
};

}  // namespace conceptplan::cli
