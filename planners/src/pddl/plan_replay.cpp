#include "conceptplan/planners/pddl/plan_replay.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "action_schemas.hpp"
#include "legality_trace.hpp"

namespace conceptplan {
namespace {

constexpr std::string_view kMeets = "its most probable outcome meets ";

/// The check that rules the action out; nothing if none does.
std::optional<Rejection> ruledOut(const SymbolGraph& graph, StateId state, Action action,
                                  double threshold) {
  const std::array<StateId, 1> states{state};
  for (const Rejection& rejection : traceRejections(graph, states, threshold)) {
    if (rejection.action == action) return rejection;
  }
  return std::nullopt;
}

std::string reasonOf(const Rejection& rejection, double threshold) {
  std::ostringstream reason;
  switch (rejection.cause) {
    case Invalidity::kNone:
      reason << "the action is not legal: its probability given the symbols is " << rejection.value
             << ", not above " << threshold;
      break;
    case Invalidity::kCollision:
      reason << kMeets << "object " << *rejection.object;
      break;
    case Invalidity::kWorkbenchEdge:
      reason << "its most probable outcome is not wholly on the workbench";
      break;
    case Invalidity::kCheckFailed:
      reason << "the validity of its most probable outcome cannot be checked";
  }
  return reason.str();
}

/// What is wrong with a step's arguments; empty if nothing, or if it has none.
std::string wrongArguments(const PlanFileStep& step, const std::vector<std::string>& expected) {
  if (step.arguments.empty()) return "";
  if (step.arguments.size() != expected.size()) {
    return "it has " + std::to_string(step.arguments.size()) + " arguments, expected " +
           std::to_string(expected.size());
  }
  const auto [found, right] =
      std::mismatch(step.arguments.begin(), step.arguments.end(), expected.begin());
  if (found == step.arguments.end()) return "";
  return "argument " + std::to_string(found - step.arguments.begin() + 1) + " is " + *found +
         ", expected " + *right;
}

/// In what a state differs from the goal; empty if in nothing.
std::string missedGoal(const SymbolGraph& graph, StateId end) {
  const std::string mismatch = frozenMismatch(graph);
  if (!mismatch.empty()) return mismatch;
  const Symbols reached = graph.symbols(end);
  const Symbols goal = mostProbable(graph.problem().goal);
  std::string text;
  for (const Concept which : changingConcepts(graph)) {
    const std::size_t k = index(which);
    if (reached[k] == goal[k]) continue;
    text += (text.empty() ? "the goal is not reached: " : ", ") + std::string(name(which)) + " " +
            std::to_string(index(reached[k])) + " in place of " + std::to_string(index(goal[k]));
  }
  return text;
}

PlanReplay replayWith(const ActionSchemas& schemas, const SymbolGraph& graph,
                      std::span<const PlanFileStep> steps, const Determinisation& determinisation) {
  PlanReplay result;
  StateId state = graph.mostProbableStart();
  for (const PlanFileStep& step : steps) {
    const auto fail = [&result](const std::string& reason,
                                std::optional<std::size_t> object = std::nullopt) {
      result.failure = ReplayFailure{result.states.size(), reason, object};
      return result;
    };
    const double threshold = determinisation.legality_threshold;
    if (const auto rejection = ruledOut(graph, state, step.action, threshold)) {
      return fail(reasonOf(*rejection, threshold), rejection->object);
    }
    const Transition& likeliest = graph.transitions(state, step.action).front();
    const std::string wrong = wrongArguments(
        step, schemas.arguments(step.action, graph.symbols(state), graph.symbols(likeliest.state)));
    if (!wrong.empty()) return fail(wrong);
    state = likeliest.state;
    result.states.push_back(state);
    result.cost += wholeCost(likeliest, determinisation);
    result.probability *= likeliest.probability;
  }
  const std::string missed = missedGoal(graph, state);
  if (!missed.empty()) result.failure = ReplayFailure{steps.size(), missed};
  return result;
}

}  // namespace

std::string explanation(const ReplayFailure& failure, std::span<const std::string> names) {
  if (!failure.object) return failure.reason;
  return std::string(kMeets) + names[*failure.object];
}

PlanReplay replay(const SymbolGraph& graph, std::span<const PlanFileStep> steps,
                  const Determinisation& determinisation) {
  checkDeterminisation(determinisation);
  return replayWith(ActionSchemas(graph, determinisation), graph, steps, determinisation);
}

PlanFile groundPlan(const SymbolGraph& graph, const ActionSequence& actions,
                    const Determinisation& determinisation) {
  checkDeterminisation(determinisation);
  const ActionSchemas schemas(graph, determinisation);
  PlanFile plan;
  for (const Action action : actions) plan.steps.push_back({action, {}, 0});
  const PlanReplay replayed = replayWith(schemas, graph, plan.steps, determinisation);
  if (replayed.failure) {
    throw std::invalid_argument("step " + std::to_string(replayed.failure->step + 1) + ": " +
                                replayed.failure->reason);
  }
  StateId before = graph.mostProbableStart();
  for (std::size_t i = 0; i < actions.size(); ++i) {
    plan.steps[i].arguments =
        schemas.arguments(actions[i], graph.symbols(before), graph.symbols(replayed.states[i]));
    before = replayed.states[i];
  }
  plan.cost = replayed.cost;
  return plan;
}

}  // namespace conceptplan
