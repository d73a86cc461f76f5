#include "conceptplan/planners/belief_update.hpp"

#include <numeric>

namespace conceptplan {
namespace {

void spread(const SymbolGraph& graph, StateId from, Action action, double mass, StateBelief& next) {
  for (const Transition& transition : graph.transitions(from, action)) {
    next[index(transition.state)] += mass * transition.probability;
  }
}

}  // namespace

StateBelief propagate(const SymbolGraph& graph, const StateBelief& belief, Action action) {
  StateBelief next(graph.numStates(), 0);
  for (std::size_t i = 0; i < belief.size(); ++i) {
    if (belief[i] > 0) spread(graph, static_cast<StateId>(i), action, belief[i], next);
  }
  return next;
}

StateBelief propagateLegal(const SymbolGraph& graph, const StateBelief& belief, Action action,
                           double threshold) {
  StateBelief next(graph.numStates(), 0);
  for (std::size_t i = 0; i < belief.size(); ++i) {
    const auto from = static_cast<StateId>(i);
    if (belief[i] > 0 && graph.legality(from, action) > threshold) {
      spread(graph, from, action, belief[i], next);
    }
  }
  return next;
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
  StateBelief all = graph.stateBelief(belief);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] *= graph.readingShare(graph.readingOf(static_cast<StateId>(i)));
  }
  StateBelief valid = all;
  keepValid(graph, valid);
  return normalize(valid) > 0 ? valid : all;
}

PlanProbability probabilityOf(const SymbolGraph& graph, const ActionSequence& actions,
                              const StateBelief& start, const StateBelief& goal, double threshold) {
  StateBelief belief = start;
  double survived = 1;
  for (const Action action : actions) {
    belief = propagateLegal(graph, belief, action, threshold);
    keepValid(graph, belief);
    survived *= normalize(belief);
  }
  const double conditional = agreement(belief, goal) * graph.frozenAgreement();
  return {survived * conditional, conditional};
}

}  // namespace conceptplan
