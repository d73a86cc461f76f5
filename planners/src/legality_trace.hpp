#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "conceptplan/planners/plan_result.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// Every action that a legality check rules out in one of these states: the action itself, or its
/// most probable next state. Each state counts once.
std::vector<Rejection> traceRejections(const SymbolGraph& graph, std::span<const StateId> states,
                                       double legality_threshold);

/// The answer under a guard of the query's limits, with what was ruled out in all states that the
/// guard was told of as expanded, if the query asks for it and the time is not up before they are
/// counted, nor the search cancelled.
PlanResult withTally(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                     const std::function<PlanResult(SearchGuard&)>& answer);

/// The states that legal actions and valid outcomes lead to from a state, itself first, by number
/// of actions; at most `most` of them and of at most `horizon` actions.
/// @param guard once it has been stopped, there are fewer; null: nothing stops it
std::vector<StateId> reachableStates(const SymbolGraph& graph, StateId from,
                                     double legality_threshold, std::size_t horizon,
                                     std::size_t most, SearchGuard* guard = nullptr);

/// Whether legal actions and valid outcomes lead from a state to the goal within the horizon; false
/// if a limit strikes before it shows.
bool isInReach(const SymbolGraph& graph, StateId start, StateId goal, double legality_threshold,
               std::size_t horizon, SearchGuard& guard);

/// Stops the guard if validity checks failed in states of the start's reading over which the goal
/// may be in reach, so that it is not proved to be out of reach.
void giveUpIfUnchecked(const SymbolGraph& graph, StateId start, StateId goal,
                       double legality_threshold, std::size_t horizon, SearchGuard& guard);

/// The concepts frozen in this problem in which start and goal most probably differ, as a sentence;
/// empty if there are none.
std::string frozenMismatch(const SymbolGraph& graph);

/// "no legal and valid steps lead to the goal within 24 actions".
std::string outOfReach(std::size_t horizon);

/// Tells why the goal is out of reach and how near the target gets to it, by all outcomes of all
/// legal actions from the most probable start: fills `reason`, `blocking` and `nearest` of the
/// result, and adds to the statistics the validity checks that it takes.
///
/// The blocking objects are `blockingObjects`, if the query has the graph's source; the reason
/// tells if they could not be found, or if the way without them is beyond the horizon. Where a
/// `frozenMismatch` is the reason, what is nearest is so by the concepts that can change. Once a
/// limit strikes, the reason alone is told, and what was found before.
void explainInfeasible(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                       SearchGuard& guard, PlanResult& result);

}  // namespace conceptplan
