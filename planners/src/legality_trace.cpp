#include "legality_trace.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "conceptplan/domain/listed.hpp"
#include "graph_blocking.hpp"
#include "graph_tables.hpp"
#include "projection_heuristic.hpp"
#include "rejection_counter.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kNotReached = std::numeric_limits<std::size_t>::max();

/// Scene index of the i-th object that is not the target.
std::size_t sceneIndex(const SymbolGraph& graph, std::size_t other) {
  return other < graph.problem().initial.target ? other : other + 1;
}

bool isValid(const Verdict& verdict) { return verdict.valid(); }

bool isUnchecked(const Verdict& verdict) { return verdict.cause == Invalidity::kCheckFailed; }

/// Fewest actions from a state to each other one by legal actions and any outcomes, kNotReached if
/// there is no way of at most so many, or if a limit strikes before one is found.
/// @param passable of the verdict of a state
template <typename Passable>
std::vector<std::size_t> actionsFrom(const SymbolGraph& graph, StateId from,
                                     double legality_threshold, std::size_t most,
                                     const Passable& passable, SearchGuard& guard) {
  std::vector<std::size_t> actions(graph.numStates(), kNotReached);
  std::vector<StateId> open{from};
  actions[index(from)] = 0;
  for (std::size_t i = 0; i < open.size() && guard.goesOn(); ++i) {
    const StateId state = open[i];
    if (actions[index(state)] == most) break;
    const StateActions at(graph, state);
    for (const Action action : kActions) {
      if (at.legality(action) <= legality_threshold) continue;
      for (const Transition& outcome : at.transitions(action)) {
        std::size_t& reached = actions[index(outcome.state)];
        if (reached != kNotReached || !passable(graph.verdict(outcome.state))) continue;
        reached = actions[index(state)] + 1;
        open.push_back(outcome.state);
      }
    }
  }
  return actions;
}

/// Of the states reached within the horizon, the one from which the concepts, each by itself, need
/// the fewest actions to the goal; then the one that shares most symbols with it. Nothing if a
/// limit strikes.
std::optional<StateId> nearestReached(const SymbolGraph& graph, StateId goal,
                                      double legality_threshold,
                                      const std::vector<std::size_t>& actions, std::size_t horizon,
                                      SearchGuard& guard) {
  const ProjectionHeuristic distance(
      graph, goal, anyOutcomeSuccessors(graph, legality_threshold, &guard), &guard);
  const Symbols wanted = graph.symbols(goal);
  StateId nearest{};
  std::tuple<PathCost, int, std::size_t> least{kOutOfReach, std::numeric_limits<int>::max(), 0};
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (!guard.goesOn()) return std::nullopt;
    if (actions[i] > horizon) continue;
    const auto state = static_cast<StateId>(i);
    const Symbols symbols = graph.symbols(state);
    int different = 0;
    for (std::size_t k = 0; k < kNumConcepts; ++k) different += symbols[k] != wanted[k] ? 1 : 0;
    const std::tuple rank{distance(state), different, actions[i]};
    if (rank < least) {
      least = rank;
      nearest = state;
    }
  }
  return nearest;
}

std::string differences(const Symbols& a, const Symbols& b) {
  std::vector<std::string> concepts;
  for (const Concept which : kConcepts) {
    if (a[index(which)] != b[index(which)]) concepts.emplace_back(name(which));
  }
  return listed(concepts);
}

/// Calls `visit` with each action that a legality check rules out in the state.
template <typename Visitor>
void forEachRejection(const SymbolGraph& graph, StateId state, double legality_threshold,
                      const Visitor& visit) {
  const StateActions at(graph, state);
  for (const Action action : kActions) {
    const double legality = at.legality(action);
    if (legality <= legality_threshold) {
      visit(Rejection{graph.symbols(state), action, Invalidity::kNone, std::nullopt, legality});
      continue;
    }
    const Verdict& verdict = graph.verdict(at.transitions(action).front().state);
    if (verdict.valid()) continue;
    Rejection rejection{graph.symbols(state), action, verdict.cause, std::nullopt,
                        verdict.clearance_m};
    if (verdict.cause == Invalidity::kCollision) {
      rejection.object = sceneIndex(graph, verdict.object);
    }
    visit(rejection);
  }
}

}  // namespace

std::vector<Rejection> traceRejections(const SymbolGraph& graph, std::span<const StateId> states,
                                       double legality_threshold) {
  std::vector<bool> done(graph.numStates(), false);
  std::vector<Rejection> rejections;
  for (const StateId state : states) {
    if (done[index(state)]) continue;
    done[index(state)] = true;
    forEachRejection(graph, state, legality_threshold,
                     [&](const Rejection& rejection) { rejections.push_back(rejection); });
  }
  return rejections;
}

PlanResult withTally(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                     const std::function<PlanResult(SearchGuard&)>& answer) {
  std::vector<bool> expanded(query.count_rejections ? graph.numStates() : 0, false);
  SearchGuard guard(query.limits, query.count_rejections ? &expanded : nullptr);
  PlanResult result = answer(guard);
  RejectionTally tally;
  RejectionCounter counter;
  for (std::size_t i = 0; i < expanded.size(); ++i) {
    if (!expanded[i]) continue;
    if (!guard.hasTime()) return result;
    ++tally.states;
    forEachRejection(graph, static_cast<StateId>(i), legality_threshold,
                     [&](const Rejection& rejection) { counter.add(rejection); });
  }
  tally.counts = counter.counts();
  if (tally.states > 0) result.ruled_out = std::move(tally);
  return result;
}

std::vector<StateId> reachableStates(const SymbolGraph& graph, StateId from,
                                     double legality_threshold, std::size_t horizon,
                                     std::size_t most, SearchGuard* guard) {
  std::vector<bool> seen(graph.numStates(), false);
  std::vector<StateId> states{from};
  seen[index(from)] = true;
  std::size_t layer_begin = 0;
  for (std::size_t depth = 0; depth < horizon && layer_begin < states.size(); ++depth) {
    const std::size_t layer_end = states.size();
    for (; layer_begin < layer_end; ++layer_begin) {
      if (guard != nullptr && !guard->goesOn()) return states;
      const StateActions at(graph, states[layer_begin]);
      for (const Action action : kActions) {
        if (at.legality(action) <= legality_threshold) continue;
        for (const Transition& transition : at.transitions(action)) {
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

bool isInReach(const SymbolGraph& graph, StateId start, StateId goal, double legality_threshold,
               std::size_t horizon, SearchGuard& guard) {
  return actionsFrom(graph, start, legality_threshold, horizon, isValid, guard)[index(goal)] !=
         kNotReached;
}

void giveUpIfUnchecked(const SymbolGraph& graph, StateId start, StateId goal,
                       double legality_threshold, std::size_t horizon, SearchGuard& guard) {
  const std::vector<Verdict>& verdicts = graph.tables().readings[graph.readingOf(start)].verdicts;
  if (std::none_of(verdicts.begin(), verdicts.end(), isUnchecked)) return;
  const std::vector<std::size_t> actions = actionsFrom(
      graph, start, legality_threshold, horizon,
      [](const Verdict& verdict) { return verdict.valid() || isUnchecked(verdict); }, guard);
  if (guard.stopped() || actions[index(goal)] == kNotReached) return;
  std::size_t unchecked = 0;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const auto state = static_cast<StateId>(i);
    // That of the start is not asked for.
    if (state != start && actions[i] != kNotReached && isUnchecked(graph.verdict(state)))
      ++unchecked;
  }
  if (unchecked == 0) return;
  guard.stop(PlanStatus::kLimit, "no plan was found, but the validity check failed in " +
                                     std::to_string(unchecked) + " states over which one may lead");
}

void explainInfeasible(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                       SearchGuard& guard, PlanResult& result) {
  const std::size_t horizon = query.limits.horizon;
  const StateId start = graph.mostProbableStart();
  const StateId goal = graph.mostProbableGoal();
  const std::string mismatch = frozenMismatch(graph);
  result.reason = mismatch.empty() ? outOfReach(horizon) : mismatch;
  const std::vector<std::size_t> actions =
      actionsFrom(graph, start, legality_threshold, kNotReached, isValid, guard);
  if (guard.stopped()) return;
  if (mismatch.empty() && actions[index(goal)] <= horizon) {
    result.reason += " unless an action has an outcome that is not its most probable one";
    return;
  }
  const auto nearest = nearestReached(graph, goal, legality_threshold, actions, horizon, guard);
  if (!nearest) return;
  result.nearest = {graph.symbols(*nearest)};
  if (mismatch.empty() && actions[index(goal)] != kNotReached) {
    result.reason += "; it takes at least " + std::to_string(actions[index(goal)]);
    return;
  }
  if (mismatch.empty()) {
    result.reason += "; what is in reach differs from the goal at least in " +
                     differences(result.nearest.front(), graph.symbols(goal));
  }
  if (query.source == nullptr) return;
  const BlockingObjects blocking =
      blockingObjects(graph, *query.source, legality_threshold, guard, result.statistics);
  result.blocking = blocking.objects;
  result.reason += remark(blocking, horizon, guard);
}

std::string outOfReach(std::size_t horizon) {
  return "no legal and valid steps lead to the goal within " + std::to_string(horizon) + " actions";
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
