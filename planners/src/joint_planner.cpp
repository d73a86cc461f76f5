#include "conceptplan/planners/joint_planner.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <utility>

#include "belief_check.hpp"
#include "joint_blocking.hpp"
#include "joint_search.hpp"
#include "option_range.hpp"
#include "path_rank.hpp"
#include "rejection_counter.hpp"
#include "scene_readings.hpp"

namespace conceptplan {
namespace {

/// States around the start whose rejections are told of when there is no plan.
constexpr std::size_t kTracedStates = 64;

void checkProblem(const JointProblem& problem, const ConceptCardinality& cardinality) {
  if (problem.targets.empty()) throw std::invalid_argument("the problem has no targets");
  for (std::size_t i = 0; i < problem.objects.size(); ++i) {
    checkBelief(problem.objects[i], cardinality, "object " + std::to_string(i));
  }
  std::set<std::size_t> seen;
  for (const TargetGoal& target : problem.targets) {
    const std::string object = std::to_string(target.object);
    if (target.object >= problem.objects.size()) {
      throw std::invalid_argument("a target is object " + object + " of " +
                                  std::to_string(problem.objects.size()));
    }
    if (!seen.insert(target.object).second) {
      throw std::invalid_argument("object " + object + " is a target twice");
    }
    checkBelief(target.goal, cardinality, "goal of object " + object);
  }
}

/// Pr[the objects that are no targets are as most probably read], as far as it matters.
double stillCertainty(const SymbolicModel& model, const JointProblem& problem,
                      const CompileOptions& options) {
  SymbolicScene scene{problem.workbench, {problem.objects[problem.targets.front().object]}, 0};
  for (std::size_t i = 0; i < problem.objects.size(); ++i) {
    const bool moves = std::any_of(problem.targets.begin(), problem.targets.end(),
                                   [i](const TargetGoal& target) { return target.object == i; });
    if (!moves) scene.objects.push_back(problem.objects[i]);
  }
  return probableReadings(model, scene, options).front().share;
}

/// Pr[starts and goals of the targets are as most probably read], as far as it matters.
double targetCertainty(const JointSpace& space, const JointProblem& problem) {
  double certainty = 1;
  for (std::size_t i = 0; i < problem.targets.size(); ++i) {
    const TargetGoal& target = problem.targets[i];
    for (const Concept which : kConcepts) {
      const std::size_t k = index(which);
      const std::vector<double>& start = problem.objects[target.object][k];
      if (space.target(i).isPart(which)) {
        certainty *= *std::max_element(start.begin(), start.end());
        certainty *= *std::max_element(target.goal[k].begin(), target.goal[k].end());
      } else if (space.target(i).isFrozenHere(which)) {
        certainty *= std::inner_product(start.begin(), start.end(), target.goal[k].begin(), 0.0);
      }
    }
  }
  return certainty;
}

Plan planOf(const JointSpace& space, const JointProblem& problem, const JointPath& path,
            double certainty) {
  Plan plan;
  plan.cost = toNats(path.cost);
  plan.probability = certainty;
  for (const JointSuccessor& step : path.steps) {
    plan.actions.push_back(step.step.action);
    plan.moved.push_back(problem.targets[step.target].object);
    plan.predicted.push_back(space.symbols(step.state, step.target));
    plan.probability *= step.step.probability;
  }
  return plan;
}

/// The start and the states that the steps of a path lead to, each once.
std::vector<JointState> statesAlong(const JointSpace& space, const JointPath& path) {
  std::vector<JointState> states{space.start()};
  for (const JointSuccessor& step : path.steps) {
    const bool known = std::find(states.begin(), states.end(), step.state) != states.end();
    if (!known) states.push_back(step.state);
  }
  return states;
}

/// The states that steps lead to from the start, itself first, by number of steps.
std::vector<JointState> statesAround(JointSpace& space, std::size_t most) {
  std::vector<JointState> states{space.start()};
  std::unordered_set<JointState> known{space.start()};
  std::vector<JointSuccessor> next;
  for (std::size_t i = 0; i < states.size(); ++i) {
    space.successors(states[i], next);
    for (const JointSuccessor& step : next) {
      if (states.size() == most) return states;
      if (known.insert(step.state).second) states.push_back(step.state);
    }
  }
  return states;
}

/// Nothing if the time is up, or the search cancelled, before all are counted.
std::optional<RejectionTally> tallyOf(JointSpace& space, const std::vector<JointState>& expanded,
                                      const SearchGuard& guard) {
  RejectionCounter counter;
  for (const JointState state : expanded) {
    if (!guard.hasTime()) return std::nullopt;
    space.forEachRejection(state, [&](const Rejection& rejection) { counter.add(rejection); });
  }
  return RejectionTally{expanded.size(), counter.counts()};
}

/// Tells why there is no plan, if no contradiction is the reason, and how near the targets get
/// together.
/// @param expanded all that the start leads to, where there is no contradiction
void explainInfeasible(JointSpace& space, const JointSearchOptions& search,
                       std::vector<JointState> expanded, SearchGuard& guard, PlanResult& result) {
  space.measureNearness(guard);
  std::vector<JointPath> paths;
  if (result.reason.empty()) {
    result.reason = "no legal and valid steps lead all targets to their goals within " +
                    std::to_string(search.horizon) + " actions";
  } else if (!guard.stopped()) {
    // No goal that can be reached is nearer than this one.
    const JointState wanted = space.goal();
    const JointState aim = space.nearestAlone(guard);
    space.aimAt(aim, guard);
    if (!guard.stopped()) paths = bestJointPaths(space, search, guard, result.statistics, expanded);
    space.aimAt(wanted, guard);
    if (!paths.empty()) expanded = {aim};
  }
  if (guard.stopped()) {
    result.reason += "; how near the targets get is not known: " + guard.reason();
    return;
  }
  const auto nearest = std::min_element(
      expanded.begin(), expanded.end(),
      [&](JointState a, JointState b) { return space.nearness(a) < space.nearness(b); });
  for (std::size_t i = 0; i < space.numTargets(); ++i) {
    result.nearest.push_back(space.symbols(*nearest, i));
  }
}

}  // namespace

JointPlanner::JointPlanner(const JointPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 0, 0.5);
}

PlanResult JointPlanner::solve(const SymbolicModel& model, const JointProblem& problem,
                               const StateValidity& validity, const PlanQuery& query) const {
  checkQuery(query);
  checkProblem(problem, model.cardinality());
  const CompileOptions compile_options;
  StepRules rules{options_.legality_threshold, compile_options.min_share,
                  compile_options.frozen_tolerance, [](double) { return kNat; }};
  if (!options_.count_actions) {
    rules.cost = [step = toPathCost(-std::log1p(-options_.step_discount))](double probability) {
      return toPathCost(-std::log(probability)) + step;
    };
  }
  PlanResult result;
  SearchGuard guard(query.limits);
  SearchStatistics making;
  std::optional<JointSpace> made = JointSpace::make(model, problem, validity, rules, guard, making);
  if (!made) {
    result.statistics = making;
    result.status = *guard.stopped();
    result.reason = guard.reason();
    return result;
  }
  JointSpace& space = *made;
  JointSearchOptions search{
      1,
      std::min(query.limits.horizon, kMostSteps / problem.targets.size()) * problem.targets.size(),
      options_.guided, options_.greedy};
  std::vector<JointPath> paths;
  std::vector<JointState> expanded;
  if (space.contradiction().empty()) {
    paths = bestJointPaths(space, search, guard, result.statistics, expanded);
  }
  if (!paths.empty() && query.top > 1) {
    // That there is no way shows soonest when one is asked for; so the others are asked for now.
    search.top = query.top;
    std::vector<JointPath> more = bestJointPaths(space, search, guard, result.statistics, expanded);
    if (!more.empty()) paths = std::move(more);
  }
  if (query.count_rejections && !expanded.empty()) {
    result.ruled_out = tallyOf(space, expanded, guard);
  }
  if (!paths.empty()) {
    const double certainty =
        stillCertainty(model, problem, compile_options) * targetCertainty(space, problem);
    for (const JointPath& path : paths) {
      result.plans.push_back(planOf(space, problem, path, certainty));
    }
    result.status = PlanStatus::kSolved;
    if (guard.stopped()) result.reason = guard.reason() + "; the best plans found so far";
  } else if (guard.stopped()) {
    result.status = *guard.stopped();
    result.reason = guard.reason();
  } else if (space.contradiction().empty() && space.failedChecks() > 0) {
    result.status = PlanStatus::kLimit;
    result.reason = "no plan was found, but " + std::to_string(space.failedChecks()) +
                    " validity checks failed of states over which one may lead";
  } else {
    result.status = PlanStatus::kInfeasible;
    result.reason = space.contradiction();
    if (space.isShutIn()) {
      const BlockingObjects blocking =
          blockingObjects(model, problem, validity, rules, search, guard, result.statistics);
      result.blocking = blocking.objects;
      result.reason += remark(blocking, search.horizon, guard);
    }
    explainInfeasible(space, search, expanded, guard, result);
  }
  const std::vector<JointState> told =
      paths.empty() ? statesAround(space, kTracedStates) : statesAlong(space, paths.front());
  for (const JointState state : told) {
    space.forEachRejection(
        state, [&](const Rejection& rejection) { result.rejections.push_back(rejection); });
  }
  result.statistics.validity_checks += space.validityChecks();
  return result;
}

}  // namespace conceptplan
