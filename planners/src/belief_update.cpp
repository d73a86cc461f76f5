#include "conceptplan/planners/belief_update.hpp"

#include <numeric>

#include "sparse_belief.hpp"

namespace conceptplan {

StateBelief propagate(const SymbolGraph& graph, const StateBelief& belief, Action action) {
  constexpr double kBelowAnyLegality = -1;
  return propagateLegal(graph, belief, action, kBelowAnyLegality);
}

StateBelief propagateLegal(const SymbolGraph& graph, const StateBelief& belief, Action action,
                           double threshold) {
  return dense(propagateLegal(graph, sparse(belief), action, threshold), graph.numStates());
}

void keepValid(const SymbolGraph& graph, StateBelief& belief) {
  for (std::size_t i = 0; i < belief.size(); ++i) {
    if (!graph.valid(static_cast<StateId>(i))) belief[i] = 0;
  }
}

double normalize(StateBelief& belief) {
  const double sum = std::accumulate(belief.begin(), belief.end(), 0.0);
  if (sum > 0) {
    for (double& mass : belief) mass /= sum;
  }
  return sum;
}

double agreement(const StateBelief& belief, const StateBelief& goal) {
  return std::inner_product(belief.begin(), belief.end(), goal.begin(), 0.0);
}

StateBelief startBelief(const SymbolGraph& graph, const SymbolBelief& belief) {
  return dense(sparseStartBelief(graph, belief), graph.numStates());
}

PlanProbability probabilityOf(const SymbolGraph& graph, const ActionSequence& actions,
                              const StateBelief& start, const StateBelief& goal, double threshold) {
  return probabilityOf(graph, actions, sparse(start), sparse(goal), threshold);
}

}  // namespace conceptplan
