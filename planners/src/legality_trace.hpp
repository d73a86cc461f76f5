#pragma once

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

/// The states that legal actions and valid outcomes lead to from a state, itself first, by number
/// of actions; at most `most` of them and of at most `horizon` actions.
std::vector<StateId> reachableStates(const SymbolGraph& graph, StateId from,
                                     double legality_threshold, std::size_t horizon,
                                     std::size_t most);

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

/// Tells why the goal is out of reach and how near the target gets to it, by all outcomes of all
/// legal actions from the most probable start: fills `reason`, `blocking` and `nearest` of the
/// result. For a task without a `frozenMismatch`.
///
/// The blocking objects are the fewest without which the goal would be in reach, however many
/// actions that took; none are named if the goal would be out of reach without any object, or if
/// the search for them grew too long. A state that meets several objects counts for the one that
/// its verdict names. Once a limit strikes, the reason alone is told.
void explainInfeasible(const SymbolGraph& graph, double legality_threshold, std::size_t horizon,
                       SearchGuard& guard, PlanResult& result);

}  // namespace conceptplan
