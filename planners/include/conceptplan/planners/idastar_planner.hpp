#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

struct IdaStarPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  double step_discount = 0.01;       ///< in [0, 0.5]
};

/// The least costly action sequence, by depth-first searches under a rising bound of cost; cost as
/// for `BestFirstPlanner`, guided by its projections. The bound at least doubles its rise, so that
/// many different costs do not make many searches, and the last search goes on to the least cost
/// below the bound. States that were searched before with as much to spend are not searched again.
/// Sources: R. E. Korf, 1985, doi:10.1016/0004-3702(85)90084-0; A. Reinefeld and T. A. Marsland,
/// 1994, doi:10.1109/34.297950; M. Helmert et al., Iterative budgeted exponential search, 2019,
/// doi:10.24963/ijcai.2019/174.
class IdaStarPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit IdaStarPlanner(const IdaStarPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  IdaStarPlannerOptions options_;
};

}  // namespace conceptplan
