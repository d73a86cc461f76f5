#include "projection_heuristic.hpp"

#include <algorithm>

namespace conceptplan {
namespace {

/// Least cost of each change of one concept's symbol, [from][to].
using SymbolCosts = std::vector<std::vector<PathCost>>;

/// Dijkstra's algorithm from the goal over the reversed, dense matrix.
std::vector<PathCost> symbolDistances(const SymbolCosts& costs, std::size_t goal) {
  std::vector<PathCost> distance(costs.size(), kOutOfReach);
  std::vector<bool> done(costs.size(), false);
  distance[goal] = 0;
  for (std::size_t round = 0; round < costs.size(); ++round) {
    std::size_t nearest = costs.size();
    for (std::size_t symbol = 0; symbol < costs.size(); ++symbol) {
      if (done[symbol] || distance[symbol] == kOutOfReach) continue;
      if (nearest == costs.size() || distance[symbol] < distance[nearest]) nearest = symbol;
    }
    if (nearest == costs.size()) break;
    done[nearest] = true;
    for (std::size_t symbol = 0; symbol < costs.size(); ++symbol) {
      if (costs[symbol][nearest] == kOutOfReach) continue;
      distance[symbol] = std::min(distance[symbol], distance[nearest] + costs[symbol][nearest]);
    }
  }
  return distance;
}

}  // namespace

ProjectionHeuristic::ProjectionHeuristic(const SymbolGraph& graph, StateId goal,
                                         const SuccessorFunction& successors)
    : graph_(graph) {
  std::array<SymbolCosts, kNumConcepts> costs;
  for (const Concept which : kConcepts) {
    if (graph.mutability(which) != Mutability::kChanges) continue;
    const std::size_t symbols = graph.problem().goal[index(which)].size();
    costs[index(which)].assign(symbols, std::vector<PathCost>(symbols, kOutOfReach));
  }
  const std::size_t states = graph.numStates() / graph.numReadings();
  std::vector<Successor> next;
  for (std::size_t i = 0; i < states; ++i) {
    const StateId state = graph.inReading(static_cast<StateId>(i), graph.readingOf(goal));
    if (!graph.valid(state)) continue;
    const Symbols before = graph.symbols(state);
    successors(state, next);
    for (const Successor& step : next) {
      const Symbols after = graph.symbols(step.state);
      std::size_t changed = 0;
      for (std::size_t k = 0; k < kNumConcepts; ++k) changed += before[k] != after[k] ? 1 : 0;
      for (std::size_t k = 0; k < kNumConcepts; ++k) {
        if (before[k] == after[k]) continue;
        PathCost& least = costs[k][index(before[k])][index(after[k])];
        least = std::min(least, step.cost / static_cast<PathCost>(changed));
      }
    }
  }
  const Symbols wanted = graph.symbols(goal);
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (!costs[k].empty()) distance_[k] = symbolDistances(costs[k], index(wanted[k]));
  }
}

PathCost ProjectionHeuristic::operator()(StateId state) const {
  const Symbols symbols = graph_.symbols(state);
  PathCost sum = 0;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (distance_[k].empty()) continue;
    const PathCost distance = distance_[k][index(symbols[k])];
    if (distance == kOutOfReach) return kOutOfReach;
    sum += distance;
  }
  return sum;
}

}  // namespace conceptplan
