#include "conceptplan/planners/planner.hpp"

#include <stdexcept>
#include <string>

namespace conceptplan {

void checkQuery(const PlanQuery& query) {
  if (query.top == 0) throw std::invalid_argument("a query must ask for at least one plan");
  if (!(query.limits.timeout_s > 0)) {
    throw std::invalid_argument("timeout_s is " + std::to_string(query.limits.timeout_s) +
                                ", expected > 0");
  }
  if (query.limits.max_expansions == 0) {
    throw std::invalid_argument("max_expansions is 0, expected at least 1");
  }
}

PlanResult Planner::solve(const SymbolGraph& graph, const PlanQuery& query) const {
  checkQuery(query);
  PlanResult result = search(graph, query);
  result.statistics.validity_checks += graph.validityChecks();
  return result;
}

}  // namespace conceptplan
