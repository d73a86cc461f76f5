#include "conceptplan/planners/value_iteration_planner.hpp"

#include "option_range.hpp"
#include "value_iteration.hpp"

namespace conceptplan {

ValueIterationPlanner::ValueIterationPlanner(const ValueIterationPlannerOptions& options)
    : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 1e-4, 0.5);
  checkOptionRange("epsilon", options.epsilon, 1e-12, 0.1);
}

PlanResult ValueIterationPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPolicy(graph, query, options_.legality_threshold, options_.step_discount,
                      [&](const GoalMdp& mdp, const PathTask& task) -> std::optional<PolicyValues> {
                        auto values =
                            valueIteration(mdp, options_.epsilon, task.guard, task.statistics);
                        if (!values) return std::nullopt;
                        return policyOf(mdp, std::move(*values));
                      });
}

}  // namespace conceptplan
