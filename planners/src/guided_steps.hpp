#pragma once

#include "path_rank.hpp"
#include "successors.hpp"

namespace conceptplan {

/// The same steps at reduced costs c + h(s') - h(s): a way from the start costs as much less as the
/// goal is nearer, and any way from start to goal h(start) less, so that searching by cost alone is
/// A*. Steps to where no way leads to the goal are left out. Not negative between valid states if
/// the heuristic is consistent. Keeps references.
/// Source: D. B. Johnson, 1977, doi:10.1145/321992.321993; A. V. Goldberg and C. Harrelson,
/// Computing the shortest path: A* search meets graph theory, SODA 2005.
/// @param Steps, Heuristic as for `bestPaths`.
template <typename Steps, typename Heuristic>
class GuidedSteps {
 public:
  GuidedSteps(const Steps& steps, const Heuristic& heuristic)
      : steps_(steps), heuristic_(heuristic) {}

  bool valid(StateId state) const { return steps_.valid(state); }

  template <typename Visitor>
  void forEach(StateId state, Visitor visit) const {
    const PathRank here = heuristic_(state);
    steps_.forEach(state, [&](Successor step) {
      const PathRank rest = heuristic_(step.state);
      if (rest == kOutOfReach) return;
      step.cost += rest - here;
      visit(step);
    });
  }

 private:
  const Steps& steps_;
  const Heuristic& heuristic_;
};

}  // namespace conceptplan
