#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

/// What guides a best-first search to the goal.
enum class Guidance {
  kNone,         ///< nothing: uniform-cost search
  kProjections,  ///< an admissible bound from the learned tables, one projection a concept
  kDistances     ///< the exact distance, from one backward search
};

struct BestFirstPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  /// A step more must raise the probability by this share; in [0, 0.5].
  double step_discount = 0.01;
  Guidance guidance = Guidance::kProjections;
  bool greedy = false;  ///< go by the guidance alone: fewer expansions, no guarantee of cost
};

/// Least costly action sequences from the most probable start to the most probable goal where each
/// action has its most probable outcome. The cost is the sum over the steps of
/// `-log Pr[outcome] - log(1 - step_discount)`. Unless greedy, the plans are exactly the `top` best
/// ones within the horizon, whatever the guidance, up to a cost of 52,776.
/// Sources: E. W. Dijkstra, 1959, doi:10.1007/BF01386390; P. E. Hart, N. J. Nilsson and B. Raphael,
/// 1968, doi:10.1109/TSSC.1968.300136.
class BestFirstPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit BestFirstPlanner(const BestFirstPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  BestFirstPlannerOptions options_;
};

}  // namespace conceptplan
