#include "path_search.hpp"

#include <algorithm>
#include <queue>
#include <span>

#include "grouped_by_end.hpp"
#include "path_rank.hpp"
#include "radix_queue.hpp"

namespace conceptplan {
namespace {

/// What waits to be expanded.
struct OpenPath {
  PathRank rank;
  std::uint32_t node;
};

/// Whether the first path is to wait for the second.
struct IsWorse {
  TieOrder ties;

  bool operator()(const OpenPath& a, const OpenPath& b) const {
    if (a.rank != b.rank) return a.rank > b.rank;
    return ties == TieOrder::kOldestFirst ? a.node > b.node : a.node < b.node;
  }
};

/// Ways that cost more, or are longer, than a rank can tell count as the greatest that it can.
PathRank nearestRank(PathCost cost, std::size_t length) {
  return rankOf(std::min(cost, costOf(kMostRank)), std::min(length, kMostSteps));
}

/// The lengths at which paths to each state were expanded, as one list a state.
class ExpandedLengths {
 public:
  explicit ExpandedLengths(std::size_t num_states) : last_(num_states, kNone) {}

  void add(StateId state, std::uint32_t length) {
    entries_.push_back({length, last_[index(state)]});
    last_[index(state)] = static_cast<std::uint32_t>(entries_.size() - 1);
  }

  /// Whether at least `count` paths no longer than `length` were expanded.
  bool has(std::size_t count, StateId state, std::uint32_t length) const {
    for (std::uint32_t i = last_[index(state)]; i != kNone; i = entries_[i].before) {
      if (entries_[i].length <= length && --count == 0) return true;
    }
    return false;
  }

 private:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  struct Entry {
    std::uint32_t length;
    std::uint32_t before;
  };

  std::vector<std::uint32_t> last_;
  std::vector<Entry> entries_;
};

/// All edges out of the states that the start leads to; nothing if a limit strikes.
std::optional<std::vector<StateEdge>> reachedEdges(std::size_t num_states, StateId start,
                                                   const SuccessorFunction& successors,
                                                   SearchGuard& guard,
                                                   SearchStatistics& statistics) {
  std::vector<StateEdge> edges;
  std::vector<bool> seen(num_states, false);
  std::vector<StateId> open{start};
  std::vector<Successor> next;
  seen[index(start)] = true;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const StateId from = open[i];
    if (!guard.expand(statistics, from)) return std::nullopt;
    successors(from, next);
    statistics.generated += next.size();
    for (const Successor& step : next) {
      edges.push_back({from, step.state, step.cost});
      if (seen[index(step.state)]) continue;
      seen[index(step.state)] = true;
      open.push_back(step.state);
    }
  }
  return edges;
}

}  // namespace

std::vector<StatePath> severalPaths(std::size_t num_states, StateId start, StateId goal,
                                    const SuccessorFunction& successors,
                                    const PathHeuristic& heuristic,
                                    const PathSearchOptions& options, SearchGuard& guard,
                                    SearchStatistics& statistics) {
  std::vector<StatePath> found;
  PathTree tree(start);
  ExpandedLengths expanded(num_states);
  std::priority_queue<OpenPath, std::vector<OpenPath>, IsWorse> open(IsWorse{options.ties});
  std::vector<Successor> next;
  if (heuristic(start) != kOutOfReach) open.push({heuristic(start), 0});
  while (!open.empty() && found.size() < options.top) {
    const std::uint32_t way = open.top().node;
    open.pop();
    const auto [state, length] = std::pair(tree[way].state, tree[way].length);
    if (expanded.has(options.top, state, length)) continue;
    if (!guard.expand(statistics, state)) break;
    expanded.add(state, length);
    if (state == goal) found.push_back(tree.path(way));
    if (length == options.horizon) continue;
    successors(state, next);
    for (const Successor& step : next) {
      const PathRank rest = heuristic(step.state);
      if (rest == kOutOfReach || expanded.has(options.top, step.state, length + 1)) continue;
      ++statistics.generated;
      const std::uint32_t node = tree.add(way, {step.action, step.state, costOf(step.cost)});
      const PathRank rank = options.greedy ? nearestRank(costOf(rest), length + 1)
                                           : nearestRank(tree[node].cost, length + 1) + rest;
      open.push({rank, node});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const StatePath& a, const StatePath& b) { return a.cost < b.cost; });
  return found;
}

std::vector<StatePath> shortestPaths(const SymbolGraph& graph, double legality_threshold,
                                     StateId start, StateId goal, PathSearchOptions options,
                                     SearchGuard& guard, SearchStatistics& statistics) {
  options.ties = TieOrder::kOldestFirst;  // so paths of one length come by their actions' order
  return bestPaths(
      graph.numStates(), start, goal,
      likelySuccessors(
          graph, legality_threshold, [](const Outcome&) { return rankOf(kNat, 1); }, &guard),
      [](StateId) { return PathRank{0}; }, options, guard, statistics);
}

std::vector<PathCost> leastCosts(std::size_t num_states, StateId goal,
                                 std::span<const StateEdge> edges, SearchGuard& guard) {
  const GroupedByEnd<StateEdge> into(num_states, edges);
  std::vector<PathCost> distance(num_states, kOutOfReach);
  RadixQueue<StateId> open(TieOrder::kNewestFirst);
  distance[index(goal)] = 0;
  open.push(0, goal);
  while (!open.empty() && guard.goesOn()) {
    const auto [key, state] = open.pop();
    const auto far = static_cast<PathCost>(key);
    if (far != distance[index(state)]) continue;  // a better way came by
    for (const StateEdge& edge : into[state]) {
      const PathCost longer = std::min(far + edge.cost, kFarthest);
      if (longer >= distance[index(edge.from)]) continue;
      distance[index(edge.from)] = longer;
      open.push(static_cast<std::uint64_t>(longer), edge.from);
    }
  }
  return distance;
}

std::optional<std::vector<PathCost>> distancesToGoal(std::size_t num_states, StateId start,
                                                     StateId goal,
                                                     const SuccessorFunction& successors,
                                                     SearchGuard& guard,
                                                     SearchStatistics& statistics) {
  const auto edges = reachedEdges(num_states, start, successors, guard, statistics);
  if (!edges) return std::nullopt;
  std::vector<PathCost> distances = leastCosts(num_states, goal, *edges, guard);
  if (guard.stopped()) return std::nullopt;
  return distances;
}

}  // namespace conceptplan
