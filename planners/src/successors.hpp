#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "conceptplan/planners/state_path.hpp"

namespace conceptplan {

/// Where no path leads.
inline constexpr PathCost kOutOfReach = std::numeric_limits<PathCost>::max();

/// One way out of a state.
struct Successor {
  Action action{};
  StateId state{};
  PathCost cost = 0;  ///< >= 0
};

/// Replaces the vector's content by all ways out of the state, in the order of `kActions`.
using SuccessorFunction = std::function<void(StateId, std::vector<Successor>&)>;

/// The problem in which every action has its most probable outcome (single-outcome
/// determinisation). Left out: actions whose legality does not exceed the threshold, outcomes that
/// are invalid, and steps that change nothing. Keeps a reference to the graph.
/// Source: S. Yoon, A. Fern and R. Givan, FF-Replan, ICAPS 2007.
SuccessorFunction likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                                   std::function<PathCost(const Transition&)> cost);

/// As above with the cost `-log Pr[outcome] - log(1 - step_discount)`: the cost of a path is the
/// negative logarithm of its discounted probability.
SuccessorFunction likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                                   double step_discount);

/// The problem in which the planner may choose among the outcomes of an action; every step costs
/// one nat. Its distances never exceed those of the problem itself.
SuccessorFunction anyOutcomeSuccessors(const SymbolGraph& graph, double legality_threshold);

}  // namespace conceptplan
