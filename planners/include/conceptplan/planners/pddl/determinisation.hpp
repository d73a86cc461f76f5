#pragma once

#include <cstdint>

#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// How a graph becomes a problem in which every action has its most probable outcome and a whole
/// cost: what PDDL can say of it. A step is allowed where its action is legal and its outcome
/// valid. The problem starts and ends with the most probable symbols; the other objects count with
/// theirs. Source: S. Yoon, A. Fern and R. Givan, FF-Replan, ICAPS 2007.
struct Determinisation {
  double legality_threshold = 0.01;  ///< in [0, 1]; legal is Pr[a | Omega] greater than this
  /// In [0, 0.5]. A step more must raise the probability by this share. With 0, sure steps are free
  /// and a cheapest plan may be longer than need be.
  double step_discount = 0.01;
  /// Units of cost in a nat, in [1, 1e9]. The standard keeps the sums of most planners, which
  /// count in 32 bits, from overflowing.
  std::int64_t cost_per_nat = 1'000'000;
};

/// @throws std::invalid_argument if a field is out of range.
void checkDeterminisation(const Determinisation& determinisation);

/// -log Pr[outcome] - log(1 - step_discount) in whole units, each term rounded; never negative.
/// @pre the determinisation is in range
std::int64_t wholeCost(const Transition& outcome, const Determinisation& determinisation);

}  // namespace conceptplan
