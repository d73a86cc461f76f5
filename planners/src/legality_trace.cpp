#include "legality_trace.hpp"

#include <algorithm>
#include <string>

namespace conceptplan {
namespace {

/// Scene index of the i-th object that is not the target.
std::size_t sceneIndex(const SymbolGraph& graph, std::size_t other) {
  return other < graph.problem().initial.target ? other : other + 1;
}

}  // namespace

std::vector<Rejection> traceRejections(const SymbolGraph& graph, std::span<const StateId> states,
                                       double legality_threshold) {
  std::vector<bool> done(graph.numStates(), false);
  std::vector<Rejection> rejections;
  for (const StateId state : states) {
    if (done[index(state)]) continue;
    done[index(state)] = true;
    for (const Action action : kActions) {
      const double legality = graph.legality(state, action);
      if (legality <= legality_threshold) {
        rejections.push_back(
            {graph.symbols(state), action, Invalidity::kNone, std::nullopt, legality});
        continue;
      }
      const Verdict& verdict = graph.verdict(graph.transitions(state, action).front().state);
      if (verdict.valid()) continue;
      Rejection rejection{graph.symbols(state), action, verdict.cause, std::nullopt,
                          verdict.clearance_m};
      if (verdict.cause == Invalidity::kCollision) {
        rejection.object = sceneIndex(graph, verdict.object);
      }
      rejections.push_back(rejection);
    }
  }
  return rejections;
}

std::vector<StateId> reachableStates(const SymbolGraph& graph, StateId from,
                                     double legality_threshold, std::size_t horizon,
                                     std::size_t most) {
  std::vector<bool> seen(graph.numStates(), false);
  std::vector<StateId> states{from};
  seen[index(from)] = true;
  std::size_t layer_begin = 0;
  for (std::size_t depth = 0; depth < horizon && layer_begin < states.size(); ++depth) {
    const std::size_t layer_end = states.size();
    for (; layer_begin < layer_end; ++layer_begin) {
      for (const Action action : kActions) {
        if (graph.legality(states[layer_begin], action) <= legality_threshold) continue;
        for (const Transition& transition : graph.transitions(states[layer_begin], action)) {
          if (!graph.valid(transition.state) || seen[index(transition.state)]) continue;
          if (states.size() >= most) return states;
          seen[index(transition.state)] = true;
          states.push_back(transition.state);
        }
      }
    }
  }
  return states;
}

std::string frozenMismatch(const SymbolGraph& graph) {
  const Symbols start = mostProbable(graph.initialBelief());
  const Symbols goal = mostProbable(graph.problem().goal);
  std::string concepts;
  for (const Concept which : kConcepts) {
    if (graph.mutability(which) != Mutability::kFrozenHere) continue;
    if (start[index(which)] == goal[index(which)]) continue;
    concepts += (concepts.empty() ? "" : " and ") + std::string(name(which));
  }
  return concepts.empty() ? "" : concepts + " must change, and nothing here changes it";
}

}  // namespace conceptplan
