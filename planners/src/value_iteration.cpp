#include "value_iteration.hpp"

#include <algorithm>
#include <cmath>

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

std::optional<std::vector<double>> valueIteration(const GoalMdp& mdp, double epsilon,
                                                  SearchGuard& guard,
                                                  SearchStatistics& statistics) {
  // The sweep contracts errors by the discount d or better, so a change of c leaves an error of
  // c d / (1 - d) at most.
  const double last_change = epsilon * (1 - mdp.discount()) / mdp.discount();
  const std::vector<StateId> order = sweepOrder(mdp);
  std::vector<double> values = mdp.optimisticValues();
  for (double change = 1; change > last_change;) {
    change = 0;
    for (const StateId state : order) {
      if (!guard.expand(statistics, state)) return std::nullopt;
      const double value = mdp.settledValue(state, values);
      change = std::max(change, std::abs(value - values[index(state)]));
      values[index(state)] = value;
    }
  }
  return values;
}

}  // namespace conceptplan
