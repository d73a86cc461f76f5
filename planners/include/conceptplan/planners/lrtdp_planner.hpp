#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

struct LrtdpPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  double step_discount = 0.01;       ///< in [0.0001, 0.5]
  double epsilon = 1e-6;             ///< residual at which a state is solved, in [1e-12, 0.1]
};

/// The problem of `ValueIterationPlanner`, solved only where the best policy leads: trials from the
/// start follow the best action known and a drawn outcome, and states are labelled solved once
/// nothing below them changes. Values begin at an upper bound, the discount to the power of the
/// fewest actions if outcomes could be chosen (h_min).
/// Source: B. Bonet and H. Geffner, Labeled RTDP, ICAPS 2003.
class LrtdpPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit LrtdpPlanner(const LrtdpPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  LrtdpPlannerOptions options_;
};

}  // namespace conceptplan
