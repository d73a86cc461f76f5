#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

struct BeamPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  double step_discount = 0.01;       ///< in [0, 0.5]
  std::size_t width = 500;           ///< action sequences kept of each length, >= 1
};

/// Action sequences that grow together by one action at a time; of each length only the best
/// `width` by cost so far and projections go on (costs as for `BestFirstPlanner`).
/// Source: B. T. Lowerre, The HARPY speech recognition system, 1976.
class BeamPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit BeamPlanner(const BeamPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  BeamPlannerOptions options_;
};

}  // namespace conceptplan
