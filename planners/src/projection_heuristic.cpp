#include "projection_heuristic.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace conceptplan {
namespace {

/// One change of a concept's symbol.
struct SymbolStep {
  std::size_t from;
  std::size_t to;
  PathCost cost;
};

/// Sums of these are at most kFarthest.
constexpr PathCost kFarthestSymbol = kFarthest / kNumConcepts;

/// Dijkstra's algorithm from the goal over the reversed steps.
std::vector<PathCost> symbolDistances(std::vector<SymbolStep> steps, std::size_t symbols,
                                      std::size_t goal) {
  std::sort(steps.begin(), steps.end(),
            [](const SymbolStep& a, const SymbolStep& b) { return a.to < b.to; });
  std::vector<PathCost> distance(symbols, kOutOfReach);
  using Reached = std::pair<PathCost, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  distance[goal] = 0;
  open.push({0, goal});
  while (!open.empty()) {
    const auto [cost, symbol] = open.top();
    open.pop();
    if (cost > distance[symbol]) continue;
    auto step = std::lower_bound(
        steps.begin(), steps.end(), symbol,
        [](const SymbolStep& entry, std::size_t wanted) { return entry.to < wanted; });
    for (; step != steps.end() && step->to == symbol; ++step) {
      const PathCost longer = std::min(cost + step->cost, kFarthestSymbol);
      if (longer >= distance[step->from]) continue;
      distance[step->from] = longer;
      open.push({distance[step->from], step->from});
    }
  }
  return distance;
}

/// The changeable concepts that the context leaves open.
SymbolIndex openConcepts(const GraphTables& graph, const SymbolIndex& context) {
  ConceptSet open{};
  for (std::size_t k = 0; k < kNumConcepts; ++k) open[k] = graph.states.has(k) && !context.has(k);
  return {open, graph.cardinality};
}

}  // namespace

ProjectionHeuristic::ProjectionHeuristic(const SymbolGraph& graph, StateId goal,
                                         const StateSteps& successors, SearchGuard* guard)
    : graph_(graph.tables()), reading_(graph_.readingOf(goal)) {
  std::array<std::vector<SymbolStep>, kNumConcepts> projected;
  const std::size_t first_state = reading_ * graph_.states.size();
  for (const StateSteps::ContextSteps& all : successors.ofReading(reading_)) {
    const SymbolIndex open = openConcepts(graph_, all.contexts);
    for (std::size_t context = 0; context < all.contexts.size(); ++context) {
      if (guard != nullptr && !guard->goesOn()) break;
      const Symbols in_context = all.contexts.symbols(context, graph_.fixed);
      for (std::uint32_t i = all.first[context]; i < all.first[context + 1]; ++i) {
        const StateSteps::Step& step = all.steps[i];
        const auto target = [&](const Symbols& symbols) {
          return static_cast<std::size_t>(
              static_cast<std::ptrdiff_t>(first_state + graph_.states(symbols)) + step.shift);
        };
        const auto before = open.find(
            in_context, [&](const Symbols& symbols) { return graph_.valid[target(symbols)] != 0; });
        if (!before) continue;
        const Symbols after = graph_.symbols(static_cast<StateId>(target(*before)));
        PathCost changed = 0;
        for (std::size_t k = 0; k < kNumConcepts; ++k) changed += (*before)[k] != after[k] ? 1 : 0;
        for (std::size_t k = 0; k < kNumConcepts; ++k) {
          if ((*before)[k] == after[k]) continue;
          projected[k].push_back({index((*before)[k]), index(after[k]), step.cost / changed});
        }
      }
    }
  }
  const Symbols wanted = graph_.symbols(goal);
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (!graph_.states.has(k)) continue;
    const auto distances =
        symbolDistances(std::move(projected[k]), graph_.cardinality[k], index(wanted[k]));
    to_goal_.insert(to_goal_.end(), distances.begin(), distances.end());
  }
}

ProjectionHeuristic::ConceptDistances ProjectionHeuristic::distances(std::size_t number) const {
  ConceptDistances distances{};
  std::size_t axis = 0;
  std::size_t first = 0;
  graph_.states.forEachSymbol(number, [&](std::uint32_t symbol, std::uint32_t cardinality) {
    distances[axis++] = to_goal_[first + symbol];
    first += cardinality;
  });
  return distances;
}

StateSteps ProjectionHeuristic::reduced(const StateSteps& steps, SearchGuard* guard) const {
  const auto reduced_cost = [&](std::size_t from, const StateSteps::Step& step) {
    const ConceptDistances before = distances(from);
    const ConceptDistances after = distances(from + static_cast<std::size_t>(step.shift));
    PathCost cost = step.cost;
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      if (before[k] == after[k]) continue;
      if (before[k] == kOutOfReach || after[k] == kOutOfReach) return kOutOfReach;
      cost += after[k] - before[k];
    }
    return cost;
  };
  return steps.atCosts(reading_, reduced_cost, guard);
}

}  // namespace conceptplan
