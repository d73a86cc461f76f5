#include "conceptplan/ompl/graph_planner.hpp"

#include <ompl/base/SolutionNonExistenceProof.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/control/PathControl.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>

#include "conceptplan/ompl/action_space.hpp"
#include "conceptplan/ompl/symbol_state_space.hpp"

namespace conceptplan {
namespace {

using ompl::base::PlannerStatus;
using StateType = SymbolStateSpace::StateType;

constexpr std::chrono::milliseconds kPollInterval{1};
constexpr double kNoTimeout_s = 1e6;

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
                      const ompl::base::PlannerTerminationCondition& termination) {
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
  query_.top = 1;
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

PlannerStatus GraphPlanner::solve(const ompl::base::PlannerTerminationCondition& termination) {
  checkValidity();
  result_ = {};
  const auto* states = si_->getStateSpace()->as<SymbolStateSpace>();
  const ompl::base::State* start = nullptr;
  for (unsigned int i = pdef_->getStartStateCount(); i-- > 0;) {
    if (si_->isValid(pdef_->getStartState(i))) start = pdef_->getStartState(i);
  }
  if (start == nullptr) return PlannerStatus::INVALID_START;
  const auto* goals = dynamic_cast<const ompl::base::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goals == nullptr) return PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  StateType goal;
  if (!goals->canSample()) return PlannerStatus::INVALID_GOAL;
  goals->sampleGoal(&goal);
  if (!states->satisfiesBounds(&goal)) return PlannerStatus::INVALID_GOAL;

  const SymbolGraph& graph = states->graph();
  const StateId from = SymbolStateSpace::id(start);
  const bool as_compiled = from == graph.mostProbableStart() && goal.id == graph.mostProbableGoal();
  result_ = as_compiled ? solveUntil(*planner_, graph, query_, termination)
                        : solveUntil(*planner_, graph.between(from, goal.id), query_, termination);
  if (result_.status == PlanStatus::kInfeasible) {
    pdef_->setSolutionNonExistenceProof(
        std::make_shared<ompl::base::SolutionNonExistenceProof>(si_));
    return infeasible<PlannerStatus::StatusType>();
  }
  if (result_.status == PlanStatus::kFailed) return PlannerStatus::CRASH;
  if (result_.plans.empty()) return PlannerStatus::TIMEOUT;

  const auto path = std::make_shared<ompl::control::PathControl>(si_);
  path->append(start);
  StateType state(from);
  ActionSpace::ControlType control;
  for (const Action action : result_.plans.front().actions) {
    state.id = states->next(state.id, action);
    control.value = static_cast<int>(action);
    path->append(&state, &control, 1);
  }
  double distance = 0;
  const bool reached = goals->isSatisfied(&state, &distance);
  pdef_->addSolutionPath(path, !reached, distance, getName());
  return {true, !reached};
}

}  // namespace conceptplan
