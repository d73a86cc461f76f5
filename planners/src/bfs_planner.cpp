#include "conceptplan/planners/bfs_planner.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>

#include "conceptplan/planners/belief_update.hpp"
#include "legality_trace.hpp"
#include "search_guard.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kTracedStates = 64;
constexpr std::size_t kOutOfReach = std::numeric_limits<std::size_t>::max();

/// The graph in which every action has its most probable outcome.
class LikelyGraph {
 public:
  LikelyGraph(const SymbolGraph& graph, double threshold) : graph_(graph), threshold_(threshold) {}

  /// Where the action leads; nothing if it is not legal, leads to an invalid state or to none new.
  std::optional<StateId> next(StateId state, Action action) const {
    if (graph_.legality(state, action) <= threshold_) return std::nullopt;
    const StateId target = graph_.transitions(state, action).front().state;
    if (target == state || !graph_.valid(target)) return std::nullopt;
    return target;
  }

 private:
  const SymbolGraph& graph_;
  double threshold_;
};

/// Fewest actions from each state to the goal, kOutOfReach where there is no way or only ways out
/// of what was explored from the start.
std::vector<std::size_t> distancesToGoal(const SymbolGraph& graph, const LikelyGraph& likely,
                                         StateId start, StateId goal, SearchGuard& guard,
                                         SearchStatistics& statistics) {
  std::vector<std::vector<StateId>> before(graph.numStates());
  std::vector<bool> seen(graph.numStates(), false);
  std::vector<StateId> open{start};
  seen[index(start)] = true;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!guard.expand(statistics)) break;
    for (const Action action : kActions) {
      const std::optional<StateId> next = likely.next(open[i], action);
      if (!next) continue;
      ++statistics.generated;
      before[index(*next)].push_back(open[i]);
      if (seen[index(*next)]) continue;
      seen[index(*next)] = true;
      open.push_back(*next);
    }
  }
  std::vector<std::size_t> distance(graph.numStates(), kOutOfReach);
  std::vector<StateId> layer{goal};
  distance[index(goal)] = 0;
  for (std::size_t i = 0; i < layer.size(); ++i) {
    for (const StateId state : before[index(layer[i])]) {
      if (distance[index(state)] != kOutOfReach) continue;
      distance[index(state)] = distance[index(layer[i])] + 1;
      layer.push_back(state);
    }
  }
  return distance;
}

struct Partial {
  std::size_t total;  ///< length of the shortest completion
  ActionSequence actions;
  StateId state;

  bool operator<(const Partial& other) const {  // worse is less
    return total != other.total ? total > other.total : actions > other.actions;
  }
};

}  // namespace

BfsPlanner::BfsPlanner(const BfsPlannerOptions& options) : options_(options) {
  if (!(options.legality_threshold >= 0 && options.legality_threshold <= 1)) {
    throw std::invalid_argument("legality_threshold is " +
                                std::to_string(options.legality_threshold) +
                                ", expected a number in [0, 1]");
  }
}

PlanResult BfsPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  const LikelyGraph likely(graph, options_.legality_threshold);
  const StateId start = graph.mostProbableStart();
  const StateId goal = graph.mostProbableGoal();
  PlanResult result;
  SearchGuard guard(query.limits);
  const auto refuse = [&](PlanStatus status, std::string reason) {
    result.status = status;
    result.reason = std::move(reason);
    result.rejections = traceRejections(graph,
                                        reachableStates(graph, start, options_.legality_threshold,
                                                        query.limits.horizon, kTracedStates),
                                        options_.legality_threshold);
    return result;
  };
  if (std::string mismatch = frozenMismatch(graph); !mismatch.empty()) {
    return refuse(PlanStatus::kInfeasible, std::move(mismatch));
  }
  const std::vector<std::size_t> distance =
      distancesToGoal(graph, likely, start, goal, guard, result.statistics);
  if (distance[index(start)] > query.limits.horizon) {
    if (guard.stopped()) return refuse(*guard.stopped(), guard.reason());
    return refuse(PlanStatus::kInfeasible, "no legal and valid steps lead to the goal within " +
                                               std::to_string(query.limits.horizon) + " actions");
  }

  const StateBelief start_belief = startBelief(graph, graph.initialBelief());
  const StateBelief goal_belief = graph.stateBelief(graph.problem().goal);
  std::vector<std::size_t> visits(graph.numStates(), 0);
  std::priority_queue<Partial> open;
  open.push({distance[index(start)], {}, start});
  std::vector<StateId> along;
  while (!open.empty() && result.plans.size() < query.top) {
    const Partial partial = open.top();
    open.pop();
    if (visits[index(partial.state)]++ >= query.top) continue;
    if (partial.state == goal) {
      Plan plan;
      plan.actions = partial.actions;
      plan.cost = static_cast<double>(partial.actions.size());
      plan.probability =
          probabilityOf(graph, plan.actions, start_belief, goal_belief, options_.legality_threshold)
              .joint;
      StateId state = start;
      for (const Action action : plan.actions) {
        if (result.plans.empty()) along.push_back(state);
        state = *likely.next(state, action);
        plan.predicted.push_back(graph.symbols(state));
      }
      if (result.plans.empty()) along.push_back(state);
      result.plans.push_back(std::move(plan));
    }
    if (!guard.expand(result.statistics)) break;
    for (const Action action : kActions) {
      const std::optional<StateId> next = likely.next(partial.state, action);
      if (!next || distance[index(*next)] == kOutOfReach) continue;
      const std::size_t total = partial.actions.size() + 1 + distance[index(*next)];
      if (total > query.limits.horizon) continue;
      ++result.statistics.generated;
      Partial longer{total, partial.actions, *next};
      longer.actions.push_back(action);
      open.push(std::move(longer));
    }
  }
  if (result.plans.empty()) return refuse(*guard.stopped(), guard.reason());
  result.status = PlanStatus::kSolved;
  result.reason = guard.reason();
  result.rejections = traceRejections(graph, along, options_.legality_threshold);
  return result;
}

}  // namespace conceptplan
