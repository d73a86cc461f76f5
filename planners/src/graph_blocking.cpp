#include "graph_blocking.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "graph_tables.hpp"
#include "grouped_by_end.hpp"
#include "legality_trace.hpp"

namespace conceptplan {
namespace {

/// States looked at or compiled, in all.
constexpr std::size_t kMostVisits = 10'000'000;

/// Calls `visit` with all that legal actions lead to from a state.
template <typename Visitor>
void forEachNext(const SymbolGraph& graph, double legality_threshold, StateId state,
                 const Visitor& visit) {
  const StateActions at(graph, state);
  for (const Action action : kActions) {
    if (at.legality(action) <= legality_threshold) continue;
    for (const Transition& outcome : at.transitions(action)) visit(outcome.state);
  }
}

struct Step {
  StateId from;
  StateId to;
};
using StepsBack = GroupedByEnd<Step>;

/// From where legal actions lead to each state, in the most probable reading.
/// @param guard once it has been stopped, the steps have no use
StepsBack stepsBack(const SymbolGraph& graph, double legality_threshold, SearchGuard& guard) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < graph.tables().states.size() && guard.goesOn(); ++i) {
    const auto from = static_cast<StateId>(i);
    forEachNext(graph, legality_threshold, from, [&](StateId to) { steps.push_back({from, to}); });
  }
  return {graph.numStates(), steps};
}

/// All states that the start leads to, or all that lead to the goal, over valid ones, and what is
/// met beside them.
class Flood {
 public:
  /// @param others the scene's indices of the objects that are not the target
  /// @param back for what leads to the goal; null: what the start leads to
  Flood(const SymbolGraph& graph, double legality_threshold, const SceneObjects& others,
        const StepsBack* back)
      : graph_(graph),
        legality_threshold_(legality_threshold),
        others_(others),
        back_(back),
        start_(graph.mostProbableStart()),
        seen_(graph.numStates(), false) {
    look(back == nullptr ? start_ : graph.mostProbableGoal());
  }

  /// Goes on as if the objects were away, and what meets one of them met no other.
  void free(const SceneObjects& objects) {
    freed_ = objects;
    visits_ = 0;
    for (const std::size_t object : objects) {
      const std::vector<StateId>& states = beside_[object];
      open_.insert(open_.end(), states.begin(), states.end());
      beside_.erase(object);
    }
  }

  /// The fewest steps to a state, from where it began or went on; nothing if it is not reached or a
  /// limit strikes.
  std::optional<std::size_t> stepsTo(StateId end, SearchGuard& guard) {
    for (std::size_t steps = 0; !open_.empty(); ++steps) {
      for (const StateId state : std::exchange(open_, {})) {
        if (!guard.goesOn()) return std::nullopt;
        if (state == end) return steps;
        ++visits_;
        expand(state);
      }
    }
    return std::nullopt;
  }

  /// States looked at since it began or went on.
  std::size_t visits() const { return visits_; }

  SceneObjects met() const {
    SceneObjects objects;
    for (const auto& [object, states] : beside_) objects.push_back(object);
    return objects;
  }

 private:
  void expand(StateId state) {
    if (back_ == nullptr) {
      forEachNext(graph_, legality_threshold_, state, [this](StateId next) { look(next); });
    } else {
      for (const Step& step : (*back_)[state]) look(step.from);
    }
  }

  void look(StateId state) {
    if (seen_[index(state)]) return;
    seen_[index(state)] = true;
    const Verdict& verdict = graph_.verdict(state);
    if (state == start_ || verdict.valid()) {  // that of the start is not asked for
      open_.push_back(state);
    } else if (verdict.cause == Invalidity::kCollision) {
      const std::size_t object = others_[verdict.object];
      const bool is_free = std::ranges::binary_search(freed_, object);
      (is_free ? open_ : beside_[object]).push_back(state);
    }
  }

  const SymbolGraph& graph_;
  double legality_threshold_;
  SceneObjects others_;
  const StepsBack* back_;
  StateId start_;
  SceneObjects freed_;
  std::vector<bool> seen_;
  std::vector<StateId> open_;
  std::map<std::size_t, std::vector<StateId>> beside_;  // by the object that is met
  std::size_t visits_ = 0;
};

SymbolicProblem problemWithout(const SymbolicProblem& problem, const SceneObjects& removed) {
  SymbolicProblem rest = problem;
  rest.initial.objects.clear();
  for (const std::size_t object : allBut(removed, problem.initial.objects.size())) {
    if (object == problem.initial.target) rest.initial.target = rest.initial.objects.size();
    rest.initial.objects.push_back(problem.initial.objects[object]);
  }
  return rest;
}

/// What becomes of a problem without some of its objects.
class Removals {
 public:
  Removals(const SymbolGraph& graph, const GraphSource& source, double legality_threshold,
           SearchGuard& guard, SearchStatistics& statistics)
      : graph_(graph),
        source_(source),
        legality_threshold_(legality_threshold),
        guard_(guard),
        statistics_(statistics),
        target_{graph.problem().initial.target},
        all_(removableObjects(source.model, graph.problem().initial.objects, target_)),
        back_(stepsBack(graph, legality_threshold, guard)),
        from_start_(floodOf(graph, {}, nullptr)),
        to_goal_(floodOf(graph, {}, &back_)) {
    from_start_.stepsTo(graph.mostProbableGoal(), guard);
    to_goal_.stepsTo(graph.mostProbableStart(), guard);
  }

  const RemovableObjects& all() const { return all_; }

  /// Without objects that are only met, nothing but verdicts changes, and at best all of those that
  /// name one. Where not even that would lead to the goal, nothing need be compiled.
  std::optional<Removal> trial(const SceneObjects& removed) {
    if (without(removed, all_.watched) == removed) {
      std::optional<Removal> at_best = found(
          graph_, from_start_, [this] { return to_goal_; }, removed);
      if (!at_best || !at_best->way) return at_best;
    }
    CompileOptions options = source_.options;
    options.max_readings = 1;  // start and goal are of the most probable one
    const std::optional<SymbolGraph> graph =
        compile(source_.model, problemWithout(graph_.problem(), removed), source_.validity, guard_,
                options);
    if (!graph) return std::nullopt;
    statistics_.validity_checks += graph->validityChecks();
    visits_ += graph->numStates();
    std::optional<StepsBack> back;
    const auto to_goal = [&] {
      back = stepsBack(*graph, legality_threshold_, guard_);
      return floodOf(*graph, removed, &*back);
    };
    return found(*graph, floodOf(*graph, removed, nullptr), to_goal, removed);
  }

 private:
  Flood floodOf(const SymbolGraph& graph, const SceneObjects& removed,
                const StepsBack* back) const {
    const SceneObjects others =
        allBut(joined(target_, removed), graph_.problem().initial.objects.size());
    return {graph, legality_threshold_, others, back};
  }

  /// A way takes one of what is met around the start and one of what is met around the goal, so it
  /// is enough to go on with the fewer.
  /// @param to_goal makes the flood that is asked for if `from_start` finds no way
  std::optional<Removal> found(const SymbolGraph& graph, Flood from_start,
                               const std::function<Flood()>& to_goal, const SceneObjects& removed) {
    if (!frozenMismatch(graph).empty()) return Removal{{}, without(all_.watched, removed)};
    from_start.free(removed);
    const auto way = from_start.stepsTo(graph.mostProbableGoal(), guard_);
    visits_ += from_start.visits();
    SceneObjects met = from_start.met();
    if (!way && !guard_.stopped()) {
      Flood from_goal = to_goal();
      from_goal.free(removed);
      from_goal.stepsTo(graph.mostProbableStart(), guard_);
      visits_ += from_goal.visits();
      const SceneObjects others = from_goal.met();
      if (others.size() < met.size()) met = others;
    }
    if (guard_.stopped() || visits_ > kMostVisits) return std::nullopt;
    return Removal{way, without(joined(met, all_.watched), removed)};
  }

  const SymbolGraph& graph_;
  const GraphSource& source_;
  double legality_threshold_;
  SearchGuard& guard_;
  SearchStatistics& statistics_;
  SceneObjects target_;
  RemovableObjects all_;
  StepsBack back_;  // with all objects, as the floods
  Flood from_start_;
  Flood to_goal_;
  std::size_t visits_ = 0;
};

}  // namespace

BlockingObjects blockingObjects(const SymbolGraph& graph, const GraphSource& source,
                                double legality_threshold, SearchGuard& guard,
                                SearchStatistics& statistics) {
  Removals removals(graph, source, legality_threshold, guard, statistics);
  return fewestBlocking(removals.all(),
                        [&](const SceneObjects& removed) { return removals.trial(removed); });
}

}  // namespace conceptplan
