#pragma once

#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// A measure over the states of a graph, [numStates]; a distribution where it sums to one.
using StateBelief = std::vector<double>;

/// Pr[Omega_t | a] = sum over o of Pr[Omega_t | a, o] Pr[o]; legality is not asked.
/// Source: Eq. (4), eq:mdpsigma1, first belief equation of Sec. III-B of arXiv 2310.03325.
StateBelief propagate(const SymbolGraph& graph, const StateBelief& belief, Action action);

/// As `propagate`, of the states with Pr[a | o] > threshold alone; what the others hold is lost.
/// Source: Eq. (5), eq:mdpsigma2, second belief equation of Sec. III-B.
StateBelief propagateLegal(const SymbolGraph& graph, const StateBelief& belief, Action action,
                           double threshold);

/// Removes what invalid states hold.
/// Source: numerator of Eq. (6), third belief equation of Sec. III-B.
void keepValid(const SymbolGraph& graph, StateBelief& belief);

/// Scales the belief to sum to one and returns what it summed to; a belief of nothing stays so.
/// Source: denominator of Eq. (6).
double normalize(StateBelief& belief);

/// Sum over o of belief(o) goal(o).
double agreement(const StateBelief& belief, const StateBelief& goal);

/// The belief at the start of a plan, over symbols and readings of the other objects: that of the
/// pictures among valid states, since the target stands somewhere; as it is if no state that it
/// holds is valid.
StateBelief startBelief(const SymbolGraph& graph, const SymbolBelief& belief);

/// What a plan achieves from a start belief.
struct PlanProbability {
  double joint = 0;        ///< Pr[goal, and every step legal and valid]
  double conditional = 0;  ///< the goal's probability under Eqs. (5) and (6), scaled at each step
};

/// Both by exact summation over all states; they include `frozenAgreement`.
PlanProbability probabilityOf(const SymbolGraph& graph, const ActionSequence& actions,
                              const StateBelief& start, const StateBelief& goal, double threshold);

}  // namespace conceptplan
