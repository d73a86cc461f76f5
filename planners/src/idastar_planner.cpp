#include "conceptplan/planners/idastar_planner.hpp"

#include <algorithm>
#include <optional>

#include "conceptplan/planners/path_planning.hpp"
#include "option_range.hpp"
#include "projection_heuristic.hpp"

namespace conceptplan {
namespace {

/// The first rise of the bound beyond the least cost that the last search cut off.
constexpr PathCost kFirstRise = kNat / 100;

class IteratedDeepening {
 public:
  IteratedDeepening(const PathTask& task, const StateSteps& successors)
      : task_(task),
        successors_(successors),
        heuristic_(task.graph, task.goal, successors, &task.guard),
        searched_(task.graph.numStates()) {}

  /// Nothing if there is no path within the horizon, or a limit struck before one was found.
  std::optional<StatePath> run() {
    PathCost bound = heuristic_(task_.start);
    for (PathCost rise = kFirstRise; bound != kOutOfReach; rise *= 2) {
      least_cut_ = kOutOfReach;
      limit_ = bound;
      for (std::vector<Searched>& records : searched_) records.clear();
      explore();
      if (best_ || task_.guard.stopped() || least_cut_ == kOutOfReach) break;
      bound = std::max(least_cut_, bound + rise);
    }
    return best_;
  }

 private:
  /// What a state was searched with during this iteration.
  struct Searched {
    PathCost budget;
    std::size_t actions;
  };

  struct Branch {
    PathCost estimate;
    Successor step;
  };

  /// A state on the path that is searched, with what is left to try from it.
  struct Level {
    PathCost cost;  ///< of the path to it
    std::vector<Branch> branches;
    std::size_t tried = 0;
  };

  /// Depth first, on a stack of its own: a path may be as long as there are states.
  void explore() {
    std::vector<Level> levels;
    if (auto branches = enter(task_.start, 0)) levels.push_back({0, std::move(*branches)});
    while (!levels.empty() && !task_.guard.stopped()) {
      Level& last = levels.back();
      if (last.tried == last.branches.size()) {
        levels.pop_back();
        if (!levels.empty()) leave();
        continue;
      }
      const Successor step = last.branches[last.tried++].step;
      const PathCost cost = last.cost + step.cost;
      path_.actions.push_back(step.action);
      path_.states.push_back(step.state);
      if (auto branches = enter(step.state, cost)) {
        levels.push_back({cost, std::move(*branches)});
      } else {
        leave();
      }
    }
  }

  void leave() {
    path_.actions.pop_back();
    path_.states.pop_back();
  }

  /// The ways out of the state to which the path leads; nothing where it need not be gone on with.
  std::optional<std::vector<Branch>> enter(StateId state, PathCost cost) {
    const PathCost estimate = cost + heuristic_(state);
    if (estimate > limit_) {
      least_cut_ = std::min(least_cut_, estimate);
      return std::nullopt;
    }
    const Searched now{limit_ - cost, task_.query.limits.horizon - path_.actions.size()};
    std::vector<Searched>& records = searched_[index(state)];
    if (std::any_of(records.begin(), records.end(), [&](const Searched& record) {
          return record.budget >= now.budget && record.actions >= now.actions;
        })) {
      return std::nullopt;
    }
    if (!task_.guard.expand(task_.statistics, state)) return std::nullopt;
    records.push_back(now);
    if (state == task_.goal) {
      best_ = path_;
      best_->cost = cost;
      limit_ = cost - 1;  // what is left to find is better
      return std::nullopt;
    }
    if (now.actions == 0) return std::nullopt;
    return branches(state);
  }

  /// The ways out that may lead to the goal, the most promising first.
  std::vector<Branch> branches(StateId state) {
    successors_(state, next_);
    std::vector<Branch> branches;
    for (const Successor& step : next_) {
      const PathCost rest = heuristic_(step.state);
      if (rest != kOutOfReach) branches.push_back({step.cost + rest, step});
    }
    task_.statistics.generated += branches.size();
    std::stable_sort(branches.begin(), branches.end(),
                     [](const Branch& a, const Branch& b) { return a.estimate < b.estimate; });
    return branches;
  }

  const PathTask& task_;
  const StateSteps& successors_;
  const ProjectionHeuristic heuristic_;
  std::vector<std::vector<Searched>> searched_;  // [states]
  std::vector<Successor> next_;
  StatePath path_;
  std::optional<StatePath> best_;
  PathCost limit_ = 0;      // of cost plus estimate
  PathCost least_cut_ = 0;  // least estimate above the limit
};

}  // namespace

IdaStarPlanner::IdaStarPlanner(const IdaStarPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 0, 0.5);
}

PlanResult IdaStarPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPaths(graph, query, options_.legality_threshold,
                     [&](const PathTask& task) -> std::vector<StatePath> {
                       const StateSteps successors = likelySuccessors(
                           graph, options_.legality_threshold, options_.step_discount, &task.guard);
                       std::optional<StatePath> best = IteratedDeepening(task, successors).run();
                       if (!best) return {};
                       return {std::move(*best)};
                     });
}

}  // namespace conceptplan
