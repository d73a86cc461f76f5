#include "conceptplan/planners/value_iteration_planner.hpp"

#include <algorithm>
#include <cmath>

#include "goal_mdp.hpp"
#include "option_range.hpp"

namespace conceptplan {
namespace {

/// States that lead to the goal, the nearest first, so that one sweep carries values all the way
/// where outcomes are sure.
std::vector<StateId> sweepOrder(const GoalMdp& mdp) {
  const std::vector<double>& nearness = mdp.optimisticValues();
  std::vector<StateId> order;
  for (std::size_t i = 0; i < nearness.size(); ++i) {
    const auto state = static_cast<StateId>(i);
    if (nearness[i] > 0 && state != mdp.goal()) order.push_back(state);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](StateId a, StateId b) { return nearness[index(a)] > nearness[index(b)]; });
  return order;
}

}  // namespace

ValueIterationPlanner::ValueIterationPlanner(const ValueIterationPlannerOptions& options)
    : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 1e-4, 0.5);
  checkOptionRange("epsilon", options.epsilon, 1e-12, 0.1);
}

PlanResult ValueIterationPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  // The sweep contracts errors by the discount d, so a change of c leaves an error of
  // c d / (1 - d) at most.
  const double last_change =
      options_.epsilon * options_.step_discount / (1 - options_.step_discount);
  return planByPolicy(graph, query, options_.legality_threshold, options_.step_discount,
                      [&](const GoalMdp& mdp, const PathTask& task) -> std::optional<PolicyValues> {
                        const std::vector<StateId> order = sweepOrder(mdp);
                        std::vector<double> values = mdp.optimisticValues();
                        for (double change = 1; change > last_change;) {
                          change = 0;
                          for (const StateId state : order) {
                            if (!task.guard.expand(task.statistics)) return std::nullopt;
                            const double value = mdp.best(state, values).value;
                            change = std::max(change, std::abs(value - values[index(state)]));
                            values[index(state)] = value;
                          }
                        }
                        return policyOf(mdp, std::move(values));
                      });
}

}  // namespace conceptplan
