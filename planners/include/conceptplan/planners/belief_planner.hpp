#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

/// How a plan's probability is made from the belief.
enum class Ranking {
  /// Pr[goal reached and every step legal and valid]: what steps ruled out by Eqs. (5) and (6)
  /// lose stays lost.
  kJoint,
  /// The paper's letter: after each step the belief is scaled to one over the valid states, so
  /// that a plan impossible from the probable start is judged from the improbable one alone.
  kConditional
};

/// Which plans share the list.
enum class Alternatives {
  kOutcomes,  ///< first plans to different outcomes, then other paths to the same ones
  kPaths      ///< strictly by probability, so often paths to one outcome in another order
};

struct BeliefPlannerOptions {
  double legality_threshold = 0.01;  ///< thresh of the paper (value not published), in [0, 1]
  bool hard_symbols = false;         ///< most probable symbols alone, as in the paper
  Ranking ranking = Ranking::kJoint;
  Alternatives alternatives = Alternatives::kOutcomes;
  /// A step more must raise the probability by this share, else the shorter plan ranks first.
  double step_discount = 0.01;  ///< in [0, 0.5]
  /// Also of a plan that was found before a limit struck and not proved best.
  double min_probability = 1e-3;  ///< of a plan where the most probable goal is out of reach
  double min_hypothesis = 1e-4;   ///< start states less probable do not guide the search
  /// Kind kOutcomes: another outcome with less than this share of the best plan's probability
  /// gives way to another path.
  double alternative_share = 0.01;
};

/// The paper's symbolic reasoner: action sequences by the probability of the goal symbols under
/// the belief of Eqs. (4)-(6) (called Eqs. 1-3 of Sec. III-B where only those are counted).
/// Exact over the joint states of the graph, where the paper treats every concept on its own.
class BeliefPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit BeliefPlanner(const BeliefPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  BeliefPlannerOptions options_;
};

}  // namespace conceptplan
