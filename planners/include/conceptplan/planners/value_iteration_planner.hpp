#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

struct ValueIterationPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  double step_discount = 0.01;       ///< in [0.0001, 0.5]
  double epsilon = 1e-6;             ///< largest error of a value, in [1e-12, 0.1]
};

/// The best policy when the symbols could be seen after each action, and action sequences from it.
///
/// The problem is a Markov decision process over the symbols, with the goal absorbing:
/// `V(goal) = 1`, `V(s) = max over a of Q(s, a)` and
/// `Q(s, a) = (1 - step_discount) * sum over valid s' of Pr[s' | a, s] V(s')` for legal actions. So
/// V is the greatest expected discounted probability of reaching the goal symbols; steps that end
/// in an invalid state lose their share.
///
/// A plan follows the outcome of each action on which its Q rests most, and its cost is
/// `-log V(start)` plus the sum over its steps of `log V(s) - log Q(s, a)`: the first plan follows
/// the policy, the others depart from it where that costs least.
/// Source: R. Bellman, A Markovian decision process, 1957.
class ValueIterationPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit ValueIterationPlanner(const ValueIterationPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  ValueIterationPlannerOptions options_;
};

}  // namespace conceptplan
