#pragma once

#include <optional>
#include <vector>

#include "goal_mdp.hpp"

namespace conceptplan {

/// The value of every state of the process to within epsilon, [states]; nothing if a limit strikes.
/// Each update is an expansion.
///
/// Values start as upper bounds and are updated in place, states nearest to the goal first, so that
/// one sweep carries a value as far as outcomes are sure.
/// Source: M. L. Puterman, Markov decision processes, 1994, Sec. 6.3.3 (Gauss-Seidel).
std::optional<std::vector<double>> valueIteration(const GoalMdp& mdp, double epsilon,
                                                  SearchGuard& guard, SearchStatistics& statistics);

}  // namespace conceptplan
