#include "successors.hpp"

#include <cmath>

namespace conceptplan {

SuccessorFunction likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                                   std::function<PathCost(const Transition&)> cost) {
  return [&graph, legality_threshold, cost = std::move(cost)](StateId state,
                                                              std::vector<Successor>& next) {
    next.clear();
    for (const Action action : kActions) {
      if (graph.legality(state, action) <= legality_threshold) continue;
      const Transition& likeliest = graph.transitions(state, action).front();
      if (likeliest.state == state || !graph.valid(likeliest.state)) continue;
      next.push_back({action, likeliest.state, cost(likeliest)});
    }
  };
}

SuccessorFunction likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                                   double step_discount) {
  return likelySuccessors(
      graph, legality_threshold,
      [step = toPathCost(-std::log1p(-step_discount))](const Transition& outcome) {
        return toPathCost(outcome.cost) + step;
      });
}

SuccessorFunction anyOutcomeSuccessors(const SymbolGraph& graph, double legality_threshold) {
  return [&graph, legality_threshold](StateId state, std::vector<Successor>& next) {
    next.clear();
    for (const Action action : kActions) {
      if (graph.legality(state, action) <= legality_threshold) continue;
      for (const Transition& outcome : graph.transitions(state, action)) {
        if (outcome.state == state || !graph.valid(outcome.state)) continue;
        next.push_back({action, outcome.state, kNat});
      }
    }
  };
}

}  // namespace conceptplan
