#include "conceptplan/planners/lrtdp_planner.hpp"

#include <cmath>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "goal_mdp.hpp"
#include "option_range.hpp"

namespace conceptplan {
namespace {

/// Labeled real-time dynamic programming.
class LabeledTrials {
 public:
  LabeledTrials(const GoalMdp& mdp, const PathTask& task, double epsilon)
      : mdp_(mdp),
        task_(task),
        epsilon_(epsilon),
        random_(stableHash({task.query.seed})),
        values_(mdp.optimisticValues()),
        solved_(values_.size(), false),
        listed_(values_.size(), false) {
    for (std::size_t i = 0; i < values_.size(); ++i) solved_[i] = values_[i] == 0;
    solved_[index(mdp.goal())] = true;
  }

  /// The values once the start is solved; nothing if a limit struck.
  std::optional<std::vector<double>> run() {
    while (!solved_[index(task_.start)]) {
      runTrial();
      if (task_.guard.stopped()) return std::nullopt;
    }
    return std::move(values_);
  }

 private:
  void runTrial() {
    std::vector<StateId> visited;
    std::optional<StateId> state = task_.start;
    while (state && !solved_[index(*state)] && visited.size() < task_.query.limits.horizon) {
      visited.push_back(*state);
      const GoalMdp::Choice choice = update(*state);
      if (task_.guard.stopped()) return;
      if (choice.value == 0) break;
      state = mdp_.draw(*state, choice.action, random_);
    }
    while (!visited.empty() && label(visited.back())) visited.pop_back();
  }

  /// Sets the state's value to that of its best action.
  GoalMdp::Choice update(StateId state) {
    if (!task_.guard.expand(task_.statistics, state)) return {};
    const GoalMdp::Choice choice = mdp_.best(state, values_);
    values_[index(state)] = choice.value;
    return choice;
  }

  /// Labels the state and all that the best actions lead to from it solved if their values hold;
  /// else improves them. Tells which.
  bool label(StateId root) {
    if (solved_[index(root)]) return true;
    bool holds = true;
    std::vector<StateId> open{root};
    std::vector<StateId> closed;
    listed_[index(root)] = true;
    while (!open.empty() && task_.guard.expand(task_.statistics, open.back())) {
      const StateId state = open.back();
      open.pop_back();
      closed.push_back(state);
      const GoalMdp::Choice choice = mdp_.best(state, values_);
      if (std::abs(values_[index(state)] - choice.value) > epsilon_) {
        holds = false;
        continue;
      }
      if (choice.value == 0) continue;
      for (const Transition& outcome : task_.graph.transitions(state, choice.action)) {
        const std::size_t next = index(outcome.state);
        if (!task_.graph.valid(outcome.state) || solved_[next] || listed_[next]) continue;
        listed_[next] = true;
        open.push_back(outcome.state);
      }
    }
    for (const StateId state : open) listed_[index(state)] = false;
    for (const StateId state : closed) listed_[index(state)] = false;
    if (task_.guard.stopped()) return false;
    for (auto state = closed.rbegin(); state != closed.rend(); ++state) {
      if (holds) {
        solved_[index(*state)] = true;
      } else {
        update(*state);
      }
    }
    return holds;
  }

  const GoalMdp& mdp_;
  const PathTask& task_;
  double epsilon_;
  std::mt19937_64 random_;
  std::vector<double> values_;
  std::vector<bool> solved_;
  std::vector<bool> listed_;  // false between calls of `label`
};

}  // namespace

LrtdpPlanner::LrtdpPlanner(const LrtdpPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 1e-4, 0.5);
  checkOptionRange("epsilon", options.epsilon, 1e-12, 0.1);
}

PlanResult LrtdpPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPolicy(graph, query, options_.legality_threshold, options_.step_discount,
                      [&](const GoalMdp& mdp, const PathTask& task) -> std::optional<PolicyValues> {
                        auto values = LabeledTrials(mdp, task, options_.epsilon).run();
                        if (!values) return std::nullopt;
                        return policyOf(mdp, std::move(*values));
                      });
}

}  // namespace conceptplan
