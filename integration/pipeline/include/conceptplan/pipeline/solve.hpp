#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conceptplan/domain/scenario/scenario.hpp"
#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/nlopt/refiner.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "conceptplan/pipeline/report.hpp"
#include "conceptplan/planners/joint_planner.hpp"
#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

struct SolveOptions {
  std::uint64_t seed = 0;
  bool render = true;   ///< draw the best plan's steps, if the scenario wants it and has pictures
  SearchLimits limits;  ///< of compiling, of the search and of the refinement, each
};

/// How many plans the top-5 measures look at.
inline constexpr std::size_t kTopPlans = 5;

/// How the plans fare in the simulator.
struct Evaluation {
  Judgement best;     ///< of the first plan
  bool top5 = false;  ///< whether one of the first five succeeds
};

struct StageTimes {
  double perceive_ms = 0;
  double compile_ms = 0;
  double search_ms = 0;
  double refine_ms = 0;
  double render_ms = 0;
  double total_ms = 0;
};

/// All that came of one scenario.
struct Solution {
  SymbolicProblem problem;  ///< with several targets, that of the first one
  /// All of several targets; empty where there is one.
  std::vector<TargetGoal> targets;
  std::vector<std::uint8_t> instances;  ///< mask id of each object of the problem
  std::vector<std::string> names;       ///< of each object of the problem, as `objectName`
  std::vector<std::string>
      doubts;         ///< what in the pictures fits no learned symbol, and what was left undone
  PlanResult result;  ///< its reason calls the objects by their names
  /// The planner's, for `reportOf`: to be filled in by whoever made the planner, who alone knows
  /// it.
  std::optional<double> legality_threshold;
  std::optional<RefinementResult> refinement;  ///< of the best plan, if the scenario asks for one
  std::vector<RgbdImage> frames;  ///< as `Model::render`, of the best plan; empty if not rendered
  std::optional<Evaluation> evaluation;  ///< if there is a reference with a solution
  StageTimes times;
};

/// From pictures (or given symbols) to plans and frames: perceive, compile with FCL validity,
/// search, refine, render, and judge if there is a reference. Thread-safe.
/// @throws InputError if the scenario does not fit the model, or its target cannot be told or is
/// hidden; if it has several targets.
Solution solveScenario(const Scenario& scenario, const Model& model, const Planner& planner,
                       const SolveOptions& options = {});

/// The same for a scenario with several targets. Its plans are not refined.
/// @throws InputError as above; std::invalid_argument if the scenario has no `targets`.
Solution solveScenario(const Scenario& scenario, const Model& model, const JointPlanner& planner,
                       const SolveOptions& options = {});

/// Judges plans, the best first, on the task that they are to solve.
/// @param instances mask id of each object that `Plan::moved` counts; none if there is one target.
Evaluation evaluationOf(const Task& task, const std::vector<Plan>& plans,
                        std::span<const std::uint8_t> instances = {});

/// The graph that `solveScenario` searches. Thread-safe.
/// @throws InputError as `solveScenario`.
SymbolGraph compileScenario(const Scenario& scenario, const Model& model);

/// The names of the objects of that graph's problem, as `objectName`. Thread-safe.
/// @throws InputError as `solveScenario`.
std::vector<std::string> objectNames(const Scenario& scenario, const Model& model);

/// The problem that two pictures pose, as the model reads them. `target` is an instance id; without
/// one it is the object whose symbols differ most between the pictures.
/// @throws std::invalid_argument if the target is not seen in both pictures, or there is none.
SymbolicProblem problemOf(const Percept& initial, const Percept& goal,
                          std::optional<std::uint8_t> target);

/// The same for several targets; reasons call them "object ID".
/// @throws std::invalid_argument if a target is not seen in both pictures.
JointProblem jointProblemOf(const Percept& initial, const Percept& goal,
                            std::span<const std::uint8_t> targets);

/// The page of a solution: pictures, symbols, plans, the refined motion, frames beside the
/// simulator's where there is a reference, rejections, times. `planner` is the planner's name.
Report reportOf(const Scenario& scenario, const Model& model, const Solution& solution,
                const std::string& planner, std::uint64_t seed);

}  // namespace conceptplan
