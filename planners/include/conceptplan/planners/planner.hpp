#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "conceptplan/planners/plan_result.hpp"
#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

struct GraphSource;

struct SearchLimits {
  double timeout_s = 10;  ///< > 0; results depend on the machine once it strikes
  std::size_t max_expansions = 20'000;
  std::size_t horizon = 24;                   ///< longest plan, in actions
  const std::atomic<bool>* cancel = nullptr;  ///< the search ends soon after it turns true
};

struct PlanQuery {
  std::size_t top = 5;  ///< most plans to return, >= 1
  SearchLimits limits = {};
  std::uint64_t seed = 0;  ///< for planners that draw
  /// Whether to fill `PlanResult::ruled_out`: takes a note of each state that the search expands.
  bool count_rejections = false;
  /// What the graph was compiled from; null: which objects block the way is not found out.
  const GraphSource* source = nullptr;
};

/// @throws std::invalid_argument if the query asks for no plan, or a limit is not positive.
void checkQuery(const PlanQuery& query);

/// Finds action sequences in a compiled problem. Same graph, query and options: same result, as
/// long as no time limit strikes. Planners keep no state between calls; threads may share one.
/// A planner of one's own overrides `search`, most easily by `planByPaths`; docs/api.md shows one.
class Planner {
 public:
  virtual ~Planner() = default;

  /// @throws std::invalid_argument as `checkQuery`.
  PlanResult solve(const SymbolGraph& graph, const PlanQuery& query) const;

 private:
  /// @pre the query is as `solve` asks for. `solve` adds the graph's own `validity_checks` to those
  /// of the statistics.
  virtual PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const = 0;
};

}  // namespace conceptplan
