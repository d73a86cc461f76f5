#include "conceptplan/planners/mcts_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "goal_mdp.hpp"
#include "option_range.hpp"

namespace conceptplan {
namespace {

constexpr double kMostIterations = std::numeric_limits<std::int32_t>::max();

/// What the runs through one action of a state returned.
struct Arm {
  double runs = 0;
  double sum = 0;

  double mean() const { return sum / runs; }
};

using Arms = std::array<Arm, kNumActions>;
using Tree = std::unordered_map<StateId, Arms>;

class Simulation {
 public:
  Simulation(const GoalMdp& mdp, const PathTask& task, double exploration)
      : mdp_(mdp),
        exploration_(exploration),
        horizon_(task.query.limits.horizon),
        start_(task.start),
        guard_(task.guard),
        random_(stableHash({task.query.seed})) {}

  /// One run from the start: through the tree, one new node, then behind it. Without effect if a
  /// limit strikes.
  void run() {
    std::vector<std::pair<StateId, Action>> steps;
    std::optional<StateId> state = start_;
    while (state && *state != mdp_.goal() && steps.size() < horizon_ && guard_.goesOn()) {
      const auto [node, is_new] = tree_.try_emplace(*state);
      if (is_new) {
        guard_.note(*state);
        break;
      }
      const std::optional<Action> action = chosen(*state, node->second);
      if (!action) break;
      steps.emplace_back(*state, *action);
      state = mdp_.draw(*state, *action, random_);
    }
    double value = state ? returnFrom(*state, steps.size()) : 0;
    if (guard_.stopped()) return;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      value *= mdp_.discount();
      Arm& arm = tree_[step->first][index(step->second)];
      arm.runs += 1;
      arm.sum += value;
    }
  }

  Tree takeTree() { return std::move(tree_); }

 private:
  /// An action not tried yet, else the one of the greatest upper confidence bound; nothing if none
  /// is legal.
  std::optional<Action> chosen(StateId state, const Arms& arms) const {
    double runs = 0;
    for (const Arm& arm : arms) runs += arm.runs;
    std::optional<Action> choice;
    double most = 0;
    for (const Action action : kActions) {
      if (!mdp_.isLegal(state, action)) continue;
      const Arm& arm = arms[index(action)];
      if (arm.runs == 0) return action;
      const double bound = arm.mean() + exploration_ * std::sqrt(std::log(runs) / arm.runs);
      if (choice && bound <= most) continue;
      choice = action;
      most = bound;
    }
    return choice;
  }

  /// What a run returns that takes the action bringing the goal nearest until the horizon.
  double returnFrom(StateId from, std::size_t steps) {
    std::optional<StateId> state = from;
    double value = 1;
    for (; state && *state != mdp_.goal() && guard_.goesOn(); ++steps) {
      const GoalMdp::Choice choice = mdp_.best(*state, mdp_.optimisticValues());
      if (steps == horizon_ || choice.value == 0) return 0;
      state = mdp_.draw(*state, choice.action, random_);
      value *= mdp_.discount();
    }
    return state ? value : 0;
  }

  const GoalMdp& mdp_;
  double exploration_;
  std::size_t horizon_;
  StateId start_;
  SearchGuard& guard_;
  std::mt19937_64 random_;
  Tree tree_;
};

/// Means where an action was tried, else its value under the upper bound of the next states.
PolicyValues meanValues(const GoalMdp& mdp, Tree tree) {
  PolicyValues values{nullptr, mdp.optimisticValues()};
  for (const auto& [state, arms] : tree) {
    double best = 0;
    for (const Arm& arm : arms) best = arm.runs > 0 ? std::max(best, arm.mean()) : best;
    if (best > 0) values.of_state[index(state)] = best;
  }
  values.of_action = [&mdp, tree = std::move(tree)](StateId state, Action action) {
    const auto node = tree.find(state);
    if (node != tree.end() && node->second[index(action)].runs > 0) {
      return node->second[index(action)].mean();
    }
    return mdp.actionValue(state, action, mdp.optimisticValues());
  };
  return values;
}

}  // namespace

MctsPlanner::MctsPlanner(const MctsPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 1e-4, 0.5);
  checkOptionRange("iterations", static_cast<double>(options.iterations), 1, kMostIterations);
  checkOptionRange("exploration", options.exploration, 0, 10);
}

PlanResult MctsPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPolicy(graph, query, options_.legality_threshold, options_.step_discount,
                      [&](const GoalMdp& mdp, const PathTask& task) -> std::optional<PolicyValues> {
                        Simulation simulation(mdp, task, options_.exploration);
                        const std::size_t left = expansionsForPlans(query) + 1;
                        for (std::size_t i = 0; i < options_.iterations; ++i) {
                          if (!task.guard.leaves(left, task.statistics)) break;
                          if (!task.guard.expand(task.statistics)) break;
                          simulation.run();
                        }
                        return meanValues(mdp, simulation.takeTree());
                      });
}

}  // namespace conceptplan
