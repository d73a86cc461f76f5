#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conceptplan/planners/pddl/determinisation.hpp"
#include "conceptplan/planners/pddl/plan_file.hpp"
#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// Where a plan fails.
struct ReplayFailure {
  std::size_t step = 0;  ///< the first that is not allowed, from 0; the number of steps if all are,
                         ///< but the goal is not reached
  std::string reason;
  std::optional<std::size_t> object = {};  ///< of the scene, by index, that the step meets

  bool operator==(const ReplayFailure&) const = default;
};

/// The reason with the object called by its name, of those of all objects of the scene.
std::string explanation(const ReplayFailure& failure, std::span<const std::string> names);

/// What came of a plan.
struct PlanReplay {
  std::vector<StateId> states;           ///< after each step that is allowed
  std::int64_t cost = 0;                 ///< of these steps, in units of the determinisation
  double probability = 1;                ///< that each of them has its most probable outcome
  std::optional<ReplayFailure> failure;  ///< nothing: the plan is right
};

/// Carries a plan out on the graph from the most probable start, every action with its most
/// probable outcome. A step is allowed where the action is legal, the outcome valid, and its
/// arguments, if it has any, are those of the exported PDDL. A step that changes nothing is
/// allowed.
/// @throws std::invalid_argument if the determinisation is out of range.
PlanReplay replay(const SymbolGraph& graph, std::span<const PlanFileStep> steps,
                  const Determinisation& determinisation = {});

/// The plan with the arguments of the exported PDDL and its cost.
/// @throws std::invalid_argument if the plan does not replay; says which step fails and why.
PlanFile groundPlan(const SymbolGraph& graph, const ActionSequence& actions,
                    const Determinisation& determinisation = {});

}  // namespace conceptplan
