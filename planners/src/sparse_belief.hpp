#pragma once

#include <vector>

#include "conceptplan/planners/belief_update.hpp"

namespace conceptplan {

/// What a belief holds of one state.
struct Mass {
  StateId state{};
  double mass = 0;
};

/// A measure over states as those that it holds, by state; masses above zero. What is computed of
/// one is, to the bit, what is computed of the `StateBelief`.
using SparseBelief = std::vector<Mass>;

SparseBelief sparse(const StateBelief& belief);
StateBelief dense(const SparseBelief& belief, std::size_t num_states);

/// `SymbolGraph::stateBelief`.
SparseBelief sparseStateBelief(const SymbolGraph& graph, const SymbolBelief& belief);

/// As the functions of the same names in belief_update.hpp.
SparseBelief propagateLegal(const SymbolGraph& graph, const SparseBelief& belief, Action action,
                            double threshold);
void keepValid(const SymbolGraph& graph, SparseBelief& belief);
double normalize(SparseBelief& belief);
double agreement(const SparseBelief& belief, const SparseBelief& goal);
SparseBelief sparseStartBelief(const SymbolGraph& graph, const SymbolBelief& belief);
PlanProbability probabilityOf(const SymbolGraph& graph, const ActionSequence& actions,
                              const SparseBelief& start, const SparseBelief& goal,
                              double threshold);

}  // namespace conceptplan
