#pragma once

#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "conceptplan/planners/path_planning.hpp"
#include "graph_tables.hpp"

namespace conceptplan {

/// The Markov decision process of `ValueIterationPlanner`.
class GoalMdp {
 public:
  /// Keeps a reference to the graph. @param distances to the goal in actions if outcomes could be
  /// chosen, counted in kNat, [states].
  GoalMdp(const SymbolGraph& graph, StateId goal, double legality_threshold, double step_discount,
          const std::vector<PathCost>& distances);

  StateId goal() const { return goal_; }
  double discount() const { return discount_; }
  bool isLegal(StateId state, Action action) const {
    return graph_.legality(state, action) > legality_threshold_;
  }

  /// An upper bound of each state's value, [states]: 0 where the goal is out of reach, 1 at the
  /// goal.
  const std::vector<double>& optimisticValues() const { return optimistic_values_; }

  /// Q(state, action) under these values of the next states; 0 if the action is not legal.
  double actionValue(StateId state, Action action, const std::vector<double>& values) const {
    return actionValue(StateActions(graph_, state), action, values);
  }

  struct Choice {
    Action action{};
    double value = 0;
  };
  /// The action of greatest Q, ties in the order of `kActions`; value 0 if there is none.
  Choice best(StateId state, const std::vector<double>& values) const;

  /// V(state) under these values of the other states: the solution of the state's own equation, in
  /// which what stays in the state is tried again. Never farther from V than `best`. Source: the
  /// Jacobi splitting of M. L. Puterman, Markov Decision Processes, 1994, Sec. 6.3.3.
  double settledValue(StateId state, const std::vector<double>& values) const;

  /// The drawn outcome of a legal action; nothing if it is not valid.
  std::optional<StateId> draw(StateId state, Action action, std::mt19937_64& random) const;

 private:
  double actionValue(const StateActions& at, Action action,
                     const std::vector<double>& values) const;

  const SymbolGraph& graph_;
  StateId goal_;
  double legality_threshold_;
  double discount_;
  std::vector<double> optimistic_values_;
};

/// What a solver knows of the values.
struct PolicyValues {
  std::function<double(StateId, Action)> of_action;  ///< Q
  std::vector<double> of_state;                      ///< V, to tell outcomes apart
};

/// Nothing if a limit struck that left no values. A solver that has some leaves
/// `expansionsForPlans`.
using MdpSolver = std::function<std::optional<PolicyValues>(const GoalMdp&, const PathTask&)>;

/// Expansions with which plans are read off the values if a limit has struck before: a tenth of
/// all, at most 1,000, or less where the plans wanted have fewer actions altogether.
std::size_t expansionsForPlans(const PlanQuery& query);

/// The policy as the solvers by whole vectors have it.
PolicyValues policyOf(const GoalMdp& mdp, std::vector<double> values);

/// The answer of a planner that solves the process and follows the policy, as described for
/// `ValueIterationPlanner`.
PlanResult planByPolicy(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                        double step_discount, const MdpSolver& solver);

}  // namespace conceptplan
