#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

struct BfsPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
};

/// Fewest actions from the most probable start to the most probable goal, where each action has
/// its most probable outcome. Plans by length, then by the order of `kActions`.
/// Source: E. F. Moore, "The shortest path through a maze", 1959.
class BfsPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit BfsPlanner(const BfsPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  BfsPlannerOptions options_;
};

}  // namespace conceptplan
