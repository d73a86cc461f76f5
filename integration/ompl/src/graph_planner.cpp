#include "conceptplan/ompl/graph_planner.hpp"

#include <ompl/base/SolutionNonExistenceProof.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/control/PathControl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <utility>
#include <vector>

#include "conceptplan/ompl/action_space.hpp"
#include "conceptplan/ompl/symbol_state_space.hpp"

namespace conceptplan {
namespace {

using ompl::base::GoalSampleableRegion;
using ompl::base::PlannerStatus;
using ompl::base::PlannerTerminationCondition;
using ompl::base::State;
using StateType = SymbolStateSpace::StateType;

constexpr std::chrono::milliseconds kPollInterval{1};
constexpr double kNoTimeout_s = 1e6;
constexpr unsigned int kMostGoalSamples = 100;

/// INFEASIBLE came after OMPL 1.5.
template <class Status>
PlannerStatus infeasible() {
  if constexpr (requires { Status::INFEASIBLE; }) {
    return Status::INFEASIBLE;
  } else {
    return Status::ABORT;
  }
}

/// Solves in another thread and cancels once the condition holds, which is only asked in this one.
PlanResult solveUntil(const Planner& planner, const SymbolGraph& graph, PlanQuery query,
                      const PlannerTerminationCondition& termination) {
  std::atomic<bool> cancel{false};
  query.limits.timeout_s = kNoTimeout_s;
  query.limits.cancel = &cancel;
  std::future<PlanResult> result =
      std::async(std::launch::async, [&] { return planner.solve(graph, query); });
  try {
    while (result.wait_for(kPollInterval) != std::future_status::ready) {
      if (termination()) cancel = true;
    }
  } catch (...) {
    cancel = true;
    throw;  // the future waits for its thread
  }
  return result.get();
}

/// Whether the goal is a fixed set of states. One of lazy samples is not.
bool consistsOfStates(const GoalSampleableRegion& goal) {
  return goal.getType() == ompl::base::GOAL_STATE || goal.getType() == ompl::base::GOAL_STATES;
}

/// All states of a goal that consists of states, else samples; nearest first.
std::vector<StateId> statesOf(const GoalSampleableRegion& goal, const SymbolStateSpace& states) {
  std::vector<std::pair<double, StateId>> found;
  const auto take = [&](const StateType& state) {
    double distance = 0;
    if (states.satisfiesBounds(&state) && goal.isSatisfied(&state, &distance)) {
      found.emplace_back(distance, state.id);
    }
  };
  if (consistsOfStates(goal)) {
    for (std::size_t i = 0; i < states.numStates(); ++i) take(StateType(static_cast<StateId>(i)));
  } else {
    for (unsigned int i = std::min(goal.maxSampleCount(), kMostGoalSamples); i > 0; --i) {
      StateType sample;
      goal.sampleGoal(&sample);
      take(sample);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<StateId> ids;
  for (const auto& [distance, id] : found) ids.push_back(id);
  return ids;
}

/// Whether valid steps, however many, lead from a start to the goal; true, too, where the condition
/// holds before that is known.
bool mayReach(const ompl::base::SpaceInformation& space, const std::vector<const State*>& starts,
              const ompl::base::Goal& goal, const PlannerTerminationCondition& termination) {
  const auto* states = space.getStateSpace()->as<SymbolStateSpace>();
  std::vector<bool> reached(states->numStates(), false);
  std::vector<StateId> open;
  const auto reach = [&](StateId id) {
    if (!reached[index(id)]) open.push_back(id);
    reached[index(id)] = true;
  };
  for (const State* start : starts) reach(SymbolStateSpace::id(start));
  for (std::size_t i = 0; i < open.size(); ++i) {
    const StateType state(open[i]);
    if (termination() || goal.isSatisfied(&state)) return true;
    for (const Action action : kActions) {
      const StateType next(states->next(state.id, action));
      if (space.isValid(&next)) reach(next.id);
    }
  }
  return false;
}

/// The path of a plan, up to the first of its steps that the space does not allow.
std::shared_ptr<ompl::control::PathControl> pathOf(const Plan& plan, const State* start,
                                                   const ompl::base::SpaceInformationPtr& space) {
  const auto* states = space->getStateSpace()->as<SymbolStateSpace>();
  auto path = std::make_shared<ompl::control::PathControl>(space);
  path->append(start);
  StateType state(SymbolStateSpace::id(start));
  ActionSpace::ControlType control;
  for (const Action action : plan.actions) {
    state.id = states->next(state.id, action);
    if (!space->isValid(&state)) break;
    control.value = static_cast<int>(action);
    path->append(&state, &control, 1);
  }
  return path;
}

}  // namespace

GraphPlanner::GraphPlanner(const ompl::control::SpaceInformationPtr& space,
                           std::shared_ptr<const conceptplan::Planner> planner,
                           const std::string& name, const PlanQuery& query)
    : Planner(space, name), planner_(std::move(planner)), query_(query) {
  if (!planner_) throw std::invalid_argument("the planner " + name + " is null");
  if (dynamic_cast<const SymbolStateSpace*>(space->getStateSpace().get()) == nullptr) {
    throw std::invalid_argument("the planner " + name + " needs a SymbolStateSpace, found " +
                                space->getStateSpace()->getName());
  }
  specs_.recognizedGoal = ompl::base::GOAL_SAMPLEABLE_REGION;
  specs_.approximateSolutions = true;
  specs_.provingSolutionNonExistence = true;
  const auto declare = [this](const std::string& limit, auto& value) {
    params_.declareParam<unsigned int>(
        limit, [&value](unsigned int given) { value = given; },
        [&value] { return static_cast<unsigned int>(value); });
  };
  declare("max_expansions", query_.limits.max_expansions);
  declare("horizon", query_.limits.horizon);
  declare("seed", query_.seed);
}

PlannerStatus GraphPlanner::solve(const PlannerTerminationCondition& termination) {
  checkValidity();
  result_ = {};
  const auto* states = si_->getStateSpace()->as<SymbolStateSpace>();
  std::vector<const State*> starts;
  for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i) {
    if (si_->isValid(pdef_->getStartState(i))) starts.push_back(pdef_->getStartState(i));
  }
  if (starts.empty()) return PlannerStatus::INVALID_START;
  const auto* goal = dynamic_cast<const GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goal == nullptr) return PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  const std::vector<StateId> goals = statesOf(*goal, *states);
  if (goals.empty()) return PlannerStatus::INVALID_GOAL;

  const SymbolGraph& graph = states->graph();
  bool proved = consistsOfStates(*goal);
  bool approximate = false;
  for (const State* start : starts) {
    const StateId from = SymbolStateSpace::id(start);
    for (const StateId to : goals) {
      const bool as_compiled = from == graph.mostProbableStart() && to == graph.mostProbableGoal();
      result_ = as_compiled ? solveUntil(*planner_, graph, query_, termination)
                            : solveUntil(*planner_, graph.between(from, to), query_, termination);
      if (result_.status == PlanStatus::kFailed) return PlannerStatus::CRASH;
      proved = proved && result_.status == PlanStatus::kInfeasible;
      for (const Plan& plan : result_.plans) {
        const auto path = pathOf(plan, start, si_);
        double distance = 0;
        const bool reached = goal->isSatisfied(path->getStates().back(), &distance);
        pdef_->addSolutionPath(path, !reached, distance, getName());
        if (reached) return PlannerStatus::EXACT_SOLUTION;
        approximate = true;
      }
      if (termination()) return {approximate, true};
    }
  }
  if (!proved || mayReach(*si_, starts, *goal, termination)) return {approximate, true};
  pdef_->setSolutionNonExistenceProof(std::make_shared<ompl::base::SolutionNonExistenceProof>(si_));
  return infeasible<PlannerStatus::StatusType>();
}

}  // namespace conceptplan
