#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "best_path.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "guided_steps.hpp"
#include "path_tree.hpp"
#include "radix_queue.hpp"

namespace conceptplan {

/// A PathRank for each state; kOutOfReach where no way leads to the goal.
using PathHeuristic = std::function<PathRank(StateId)>;

struct PathSearchOptions {
  std::size_t top = 1;      ///< paths wanted
  std::size_t horizon = 0;  ///< longest path, in actions
  bool greedy = false;      ///< go by the heuristic alone, not by the cost so far
  /// Which of equally promising paths is gone on with. The newest is mostly the nearest to the
  /// goal. Source: M. Asai and A. Fukunaga, 2017, doi:10.1613/jair.5249.
  TieOrder ties = TieOrder::kNewestFirst;
};

/// Paths from start to goal by best-first search, distinct and by rising cost; paths may pass the
/// goal and return to it. Fewer than asked for if there are no more or a limit strikes.
///
/// With a consistent heuristic and not greedy, these are exactly the least costly paths within the
/// horizon, ties going to the shorter one. A path is dropped where `top` others that cost no more
/// and are no longer have reached its end, since each of its continuations then has that many
/// rivals. So every state is expanded at most `top` times for each length, mostly `top` times in
/// all. Beyond 52,776 nats or 131,071 actions paths need not be the best.
/// @param successors with PathRanks as costs
std::vector<StatePath> severalPaths(std::size_t num_states, StateId start, StateId goal,
                                    const SuccessorFunction& successors,
                                    const PathHeuristic& heuristic,
                                    const PathSearchOptions& options, SearchGuard& guard,
                                    SearchStatistics& statistics);

/// As `severalPaths`; a single path is left to `bestPath` where it can tell. Where it cannot, what
/// it expanded counts too.
/// @param steps as for `bestPath`, and a `SuccessorFunction` with PathRanks as costs.
/// @param heuristic a consistent PathHeuristic, at most kFarthest or kOutOfReach, 0 at the goal. It
/// may know how to reduce the steps' costs beforehand, `heuristic.reduced(steps, &guard)`.
template <typename Steps, typename Heuristic>
std::vector<StatePath> bestPaths(std::size_t num_states, StateId start, StateId goal,
                                 const Steps& steps, const Heuristic& heuristic,
                                 const PathSearchOptions& options, SearchGuard& guard,
                                 SearchStatistics& statistics) {
  if (options.top == 1 && !options.greedy) {
    const PathRank least = heuristic(start);
    if (least == kOutOfReach) return {};
    const auto search = [&](const auto& guided) {
      return bestPath(num_states, start, goal, least, guided, options.horizon, options.ties, guard,
                      statistics);
    };
    std::optional<std::vector<StatePath>> best;
    if constexpr (requires { heuristic.reduced(steps, &guard); }) {
      best = search(heuristic.reduced(steps, &guard));
    } else {
      best = search(GuidedSteps(steps, heuristic));
    }
    if (best) return *std::move(best);
  }
  return severalPaths(num_states, start, goal, std::cref(steps), std::cref(heuristic), options,
                      guard, statistics);
}

/// Paths of the fewest actions from start to goal, distinct and by rising length; ties go by the
/// order of the actions, whatever `options.ties`. Every action costs one, kNat.
std::vector<StatePath> shortestPaths(const SymbolGraph& graph, double legality_threshold,
                                     StateId start, StateId goal, PathSearchOptions options,
                                     SearchGuard& guard, SearchStatistics& statistics);

/// One step between two states.
struct StateEdge {
  StateId from;
  StateId to;
  PathCost cost;  ///< >= 0
};

/// The least cost from each state to the goal along the edges, [num_states], kFarthest where it is
/// more than that, kOutOfReach where there is no way. In the unit of the edges' costs. Source: E.
/// W. Dijkstra, 1959, doi:10.1007/BF01386390, on the reversed graph. Incomplete once the guard has
/// been stopped.
std::vector<PathCost> leastCosts(std::size_t num_states, StateId goal,
                                 std::span<const StateEdge> edges, SearchGuard& guard);

/// The least cost from each state to the goal, [num_states]; kOutOfReach where there is no way and
/// for states that the start does not lead to. Nothing if a limit strikes. Source: `leastCosts`.
std::optional<std::vector<PathCost>> distancesToGoal(std::size_t num_states, StateId start,
                                                     StateId goal,
                                                     const SuccessorFunction& successors,
                                                     SearchGuard& guard,
                                                     SearchStatistics& statistics);

}  // namespace conceptplan
