#pragma once

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/planners/planner.hpp"
#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

struct JointPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  /// A step more must raise the probability by this share; in [0, 0.5].
  double step_discount = 0.01;
  bool count_actions = false;  ///< a step costs 1, whatever its probability
  bool guided = true;          ///< by the single targets' least costs; else by nothing
  bool greedy = false;         ///< go by the guidance alone: fewer expansions, no guarantee of cost
};

/// Plans for several targets on one workbench, of which each action moves one: A* on the product of
/// their states, which is never built. Each target is in the others' way, and where effects or
/// legality depend on another target, they see where that one is by then, and its symbols.
///
/// Objects have their most probable symbols, actions their most probable outcome; a step costs
/// `-log Pr[outcome] - log(1 - step_discount)`, as for `BestFirstPlanner`. The search is guided by
/// the sum over the targets of the least cost at which each would get to its goal if the others
/// were out of its way and, where its actions depend on them, wherever they serve it best. A step
/// moves one target, and is one that the target may take then; so the sum is at most what a joint
/// plan costs.
///
/// Source: the sum of single-agent costs as in D. Silver, Cooperative pathfinding, AIIDE 2005; the
/// search is that of P. E. Hart, N. J. Nilsson and B. Raphael, 1968, doi:10.1109/TSSC.1968.300136.
class JointPlanner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit JointPlanner(const JointPlannerOptions& options = {});

  /// Unless greedy, the plans are exactly the `top` best ones, by cost, then by length, up to a
  /// cost of 52,776. Plans in which each target has the same actions count as one, given in its
  /// best order. A plan has at most `horizon` actions a target, and at most 131,071.
  /// `Plan::probability` is a lower bound: that all objects are as they were most probably read,
  /// the goals too, and that each action has its most probable outcome. Thread-safe.
  ///
  /// Rejections are those of each target's own steps in a joint state; the object of a collision
  /// may be another target. What is nearest is in reach of all targets together, by the least cost
  /// to their goals if nothing were in their way; the reason says if a limit kept it unknown.
  /// Objects are said to be blocking only where they keep targets from their goals wherever the
  /// other targets are, and there is a plan without them, if perhaps beyond the horizon.
  ///
  /// @pre two objects are valid together whichever of them is asked about, which depends on the
  /// same concepts of both, and a scene is valid if its objects are so in pairs, as bodies are.
  /// @throws std::invalid_argument as `checkQuery`; if the problem has no targets, one twice or one
  /// that is no object, or a belief that does not fit the model; or if the joint states cannot be
  /// counted in 63 bits, as is so of eight targets of the standard model.
  PlanResult solve(const SymbolicModel& model, const JointProblem& problem,
                   const StateValidity& validity, const PlanQuery& query) const;

 private:
  JointPlannerOptions options_;
};

}  // namespace conceptplan
