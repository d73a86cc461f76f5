#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "conceptplan/planners/search_guard.hpp"
#include "successors.hpp"

namespace conceptplan {

/// A lower bound of the cost from a state to the goal, in the unit of the steps' costs, made from
/// the compiled tables alone: the sum over concepts of the least cost at which that concept by
/// itself can get from its symbol to the goal's. Memory: one number for each symbol of each concept
/// that changes.
///
/// The projection on concept k has an edge v -> v' wherever some step of the problem changes k from
/// v to v'. A step of cost c that changes m concepts counts c/m, rounded down, in each of them and
/// nothing in the others; an edge has the least such share of all its steps, and d_k(v) is the
/// least cost from v to the goal's symbol. h(s) is the sum of d_k over all k.
///
/// Admissible: a path to the goal projects to a path of concept k to the goal's symbol, whose edges
/// cost no more than the shares of its steps; the shares of one step sum to at most its cost, so
/// the sum over k of d_k is at most the cost of the path. Consistent: a step s -> s' of cost c
/// lowers d_k only where it changes k, and there by at most the edge's cost, so
/// h(s) <= c + h(s'). Where one action moves one concept only, as on a bench without walls, h is
/// exact.
///
/// Source: J. Culberson and J. Schaeffer, Pattern databases, 1998, doi:10.1111/0824-7935.00065;
/// costs are shared out as by M. Katz and C. Domshlak, 2010, doi:10.1016/j.artint.2010.04.021.
class ProjectionHeuristic {
 public:
  /// Looks, in the reading of the other objects that the goal is in, for one state from which each
  /// step of each context leads to a valid one. It need not be valid itself: a start is not always.
  /// @param guard once it has been stopped, the heuristic has no use; null: nothing stops it
  ProjectionHeuristic(const SymbolGraph& graph, StateId goal, const StateSteps& successors,
                      SearchGuard* guard = nullptr);

  /// kOutOfReach where some concept cannot reach the goal's symbol; keeps a reference to the graph.
  PathCost operator()(StateId state) const {
    std::uint64_t sum = 0;  // means nothing where a distance is kOutOfReach
    PathCost farthest = 0;
    std::size_t first = 0;
    graph_.states.forEachSymbol(graph_.numberInReading(state),
                                [&](std::uint32_t symbol, std::uint32_t cardinality) {
                                  const PathCost distance = to_goal_[first + symbol];
                                  first += cardinality;
                                  sum += static_cast<std::uint64_t>(distance);
                                  farthest = std::max(farthest, distance);
                                });
    return farthest == kOutOfReach ? kOutOfReach : static_cast<PathCost>(sum);
  }

  /// The steps of the goal's reading at reduced costs, as `GuidedSteps`, worked out once for each
  /// context: what a step changes is part of its context.
  /// @param guard as of `StateSteps`
  StateSteps reduced(const StateSteps& steps, SearchGuard* guard = nullptr) const;

 private:
  /// Of each concept that the states index, in their order, from its symbol to the goal's; then 0.
  using ConceptDistances = std::array<PathCost, kNumConcepts>;
  ConceptDistances distances(std::size_t number) const;

  const GraphTables& graph_;
  std::size_t reading_;
  std::vector<PathCost> to_goal_;  // of each symbol of each concept that the states index
};

}  // namespace conceptplan
