#pragma once

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

struct MctsPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  double step_discount = 0.01;       ///< in [0.0001, 0.5]
  std::size_t iterations = 500;      ///< simulated runs, >= 1
  double exploration = 0.1;          ///< weight of the confidence bound, in [0, 10]
};

/// The problem of `ValueIterationPlanner` by Monte-Carlo tree search: runs from the start choose
/// actions by upper confidence bounds (UCT), with drawn outcomes; behind the states known so far a
/// run takes the action that brings the goal nearest. The values of actions are means of runs. A
/// run is one expansion. Where a limit ends the runs, the best plans found are those of the runs so
/// far; a tenth of the expansions at most is left for them.
/// Source: L. Kocsis and C. Szepesvari, Bandit based Monte-Carlo planning, 2006,
/// doi:10.1007/11871842_29; states reached in several ways are one node.
class MctsPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit MctsPlanner(const MctsPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  MctsPlannerOptions options_;
};

}  // namespace conceptplan
