#include "goal_mdp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "path_rank.hpp"
#include "path_search.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kMostExpansionsForPlans = 1000;

/// In [0, 1).
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// What is left to read plans off values that were known when a limit struck.
SearchLimits limitsForPlans(const PathTask& task) {
  SearchLimits limits = task.query.limits;
  limits.timeout_s = std::numeric_limits<double>::infinity();
  limits.cancel = nullptr;
  limits.max_expansions =
      std::min(limits.max_expansions, task.statistics.expanded + expansionsForPlans(task.query));
  return limits;
}

/// V(state) by the action values; 1 at the goal.
double valueOfState(StateId state, StateId goal, const PolicyValues& values) {
  if (state == goal) return 1;
  double best = 0;
  for (const Action action : kActions) best = std::max(best, values.of_action(state, action));
  return best;
}

/// Each action with the outcome on which its value rests most, at the cost of preferring it to the
/// best one.
SuccessorFunction policySuccessors(const SymbolGraph& graph, StateId goal,
                                   const PolicyValues& values) {
  return [&graph, goal, &values](StateId state, std::vector<Successor>& next) {
    next.clear();
    const double best = valueOfState(state, goal, values);
    for (const Action action : kActions) {
      const double value = values.of_action(state, action);
      if (value <= 0) continue;
      std::optional<StateId> main;
      double most = 0;
      for (const Transition& outcome : graph.transitions(state, action)) {
        if (outcome.state == state || !graph.valid(outcome.state)) continue;
        const double share = outcome.probability * values.of_state[index(outcome.state)];
        if (share <= most) continue;
        main = outcome.state;
        most = share;
      }
      if (main) next.push_back({action, *main, rankOf(toPathCost(std::log(best / value)), 1)});
    }
  };
}

}  // namespace

GoalMdp::GoalMdp(const SymbolGraph& graph, StateId goal, double legality_threshold,
                 double step_discount, const std::vector<PathCost>& distances)
    : graph_(graph),
      goal_(goal),
      legality_threshold_(legality_threshold),
      discount_(1 - step_discount) {
  optimistic_values_.reserve(distances.size());
  for (const PathCost distance : distances) {
    optimistic_values_.push_back(distance == kOutOfReach ? 0
                                                         : std::pow(discount_, toNats(distance)));
  }
}

double GoalMdp::actionValue(const StateActions& at, Action action,
                            const std::vector<double>& values) const {
  if (at.legality(action) <= legality_threshold_) return 0;
  double sum = 0;
  for (const Transition& outcome : at.transitions(action)) {
    if (graph_.valid(outcome.state)) sum += outcome.probability * values[index(outcome.state)];
  }
  return discount_ * sum;
}

GoalMdp::Choice GoalMdp::best(StateId state, const std::vector<double>& values) const {
  Choice best;
  const StateActions at(graph_, state);
  for (const Action action : kActions) {
    const double value = actionValue(at, action, values);
    if (value > best.value) best = {action, value};
  }
  return best;
}

double GoalMdp::settledValue(StateId state, const std::vector<double>& values) const {
  double best = 0;
  const StateActions at(graph_, state);
  for (const Action action : kActions) {
    if (at.legality(action) <= legality_threshold_) continue;
    double left = 0, stays = 0;
    for (const Transition& outcome : at.transitions(action)) {
      if (!graph_.valid(outcome.state)) continue;
      if (outcome.state == state)
        stays += outcome.probability;
      else
        left += outcome.probability * values[index(outcome.state)];
    }
    best = std::max(best, discount_ * left / (1 - discount_ * stays));
  }
  return best;
}

std::optional<StateId> GoalMdp::draw(StateId state, Action action, std::mt19937_64& random) const {
  const TransitionRange outcomes = graph_.transitions(state, action);
  double rest = uniform(random);
  std::size_t drawn = 0;
  for (; drawn + 1 < outcomes.size() && rest >= outcomes[drawn].probability; ++drawn) {
    rest -= outcomes[drawn].probability;
  }
  if (!graph_.valid(outcomes[drawn].state)) return std::nullopt;
  return outcomes[drawn].state;
}

std::size_t expansionsForPlans(const PlanQuery& query) {
  const auto atMost = [](std::size_t count) { return std::min(count, kMostExpansionsForPlans); };
  return std::min(query.limits.max_expansions / 10,
                  atMost(atMost(query.top) * atMost(query.limits.horizon)));
}

PolicyValues policyOf(const GoalMdp& mdp, std::vector<double> values) {
  return {[&mdp, values](StateId state, Action action) {
            return mdp.actionValue(state, action, values);
          },
          values};
}

PlanResult planByPolicy(const SymbolGraph& graph, const PlanQuery& query, double legality_threshold,
                        double step_discount, const MdpSolver& solver) {
  return planByPaths(
      graph, query, legality_threshold, [&](const PathTask& task) -> std::vector<StatePath> {
        const auto distances =
            distancesToGoal(graph.numStates(), task.start, task.goal,
                            anyOutcomeSuccessors(graph, legality_threshold, &task.guard),
                            task.guard, task.statistics);
        if (!distances) return {};
        const PathCost nearest = (*distances)[index(task.start)];
        if (nearest == kOutOfReach ||
            static_cast<std::size_t>(nearest / kNat) > query.limits.horizon) {
          return {};
        }
        const GoalMdp mdp(graph, task.goal, legality_threshold, step_discount, *distances);
        const std::optional<PolicyValues> values = solver(mdp, task);
        if (!values) return {};
        SearchGuard after_limit(limitsForPlans(task), task.guard.expanded());
        std::vector<StatePath> paths = bestPaths(
            graph.numStates(), task.start, task.goal,
            FunctionSteps(policySuccessors(graph, task.goal, *values)),
            [&](StateId state) {
              return (*distances)[index(state)] == kOutOfReach ? kOutOfReach : PathRank{0};
            },
            {query.top, query.limits.horizon}, task.guard.stopped() ? after_limit : task.guard,
            task.statistics);
        if (paths.empty() && !task.guard.stopped()) {
          task.guard.stop(PlanStatus::kLimit,
                          "the goal can be reached, but not along the outcomes on which the policy "
                          "rests within " +
                              std::to_string(query.limits.horizon) + " actions");
        }
        if (paths.empty()) return {};
        const PathCost least = toPathCost(-std::log(valueOfState(task.start, task.goal, *values)));
        for (StatePath& path : paths) path.cost += least;
        return paths;
      });
}

}  // namespace conceptplan
