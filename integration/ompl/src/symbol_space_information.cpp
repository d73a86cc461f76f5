#include "conceptplan/ompl/symbol_space_information.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/control/SimpleDirectedControlSampler.h>
#include <ompl/control/StatePropagator.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "conceptplan/ompl/action_space.hpp"
#include "conceptplan/ompl/symbol_state_space.hpp"

namespace conceptplan {
namespace {

using ompl::base::State;

const SymbolStateSpace* statesOf(const ompl::base::SpaceInformation& information) {
  return information.getStateSpace()->as<SymbolStateSpace>();
}

class SymbolPropagator final : public ompl::control::StatePropagator {
 public:
  explicit SymbolPropagator(const ompl::control::SpaceInformationPtr& information)
      : StatePropagator(information), states_(statesOf(*information)) {}

  void propagate(const State* state, const ompl::control::Control* control, double duration,
                 State* result) const override {
    StateId id = SymbolStateSpace::id(state);
    if (const std::optional<Action> action = ActionSpace::action(control)) {
      for (long step = std::lround(duration); step > 0; --step) id = states_->next(id, *action);
    }
    result->as<SymbolStateSpace::StateType>()->id = id;
  }

  bool canPropagateBackward() const override { return false; }

 private:
  const SymbolStateSpace* states_;
};

class SymbolValidity final : public ompl::base::StateValidityChecker {
 public:
  explicit SymbolValidity(const ompl::base::SpaceInformationPtr& information)
      : StateValidityChecker(information), states_(statesOf(*information)) {
    specs_.clearanceComputationType = ompl::base::StateValidityCheckerSpecs::EXACT;
  }

  using StateValidityChecker::clearance;
  using StateValidityChecker::isValid;

  bool isValid(const State* state) const override {
    const StateId id = SymbolStateSpace::id(state);
    const SymbolGraph& graph = states_->graph();
    return states_->contains(id) && (graph.valid(id) || id == graph.mostProbableStart());
  }

  double clearance(const State* state) const override {
    const StateId id = SymbolStateSpace::id(state);
    return states_->contains(id) ? states_->graph().verdict(id).clearance_m : 0;
  }

 private:
  const SymbolStateSpace* states_;
};

/// The counters of the base class stay at zero: threads could not share them.
class ActionMotionValidator final : public ompl::base::MotionValidator {
 public:
  explicit ActionMotionValidator(const ompl::base::SpaceInformationPtr& information)
      : MotionValidator(information), states_(statesOf(*information)) {}

  bool checkMotion(const State* from, const State* to) const override {
    if (!si_->isValid(from) || !si_->isValid(to)) return false;
    return states_->equalStates(from, to) ||
           std::any_of(kActions.begin(), kActions.end(), [&](Action action) {
             return states_->next(SymbolStateSpace::id(from), action) == SymbolStateSpace::id(to);
           });
  }

  bool checkMotion(const State* from, const State* to,
                   std::pair<State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    if (last_valid.first != nullptr) states_->copyState(last_valid.first, from);
    last_valid.second = 0;
    return false;
  }

 private:
  const SymbolStateSpace* states_;
};

}  // namespace

ompl::control::SpaceInformationPtr makeSpaceInformation(std::shared_ptr<const SymbolGraph> graph,
                                                        const SymbolSpaceOptions& options) {
  if (options.control_samples == 0) {
    throw std::invalid_argument("control_samples is 0, expected at least 1");
  }
  const auto states = std::make_shared<SymbolStateSpace>(
      std::move(graph), options.legality_threshold, options.check_motion);
  const auto actions = std::make_shared<ActionSpace>(states);
  if (options.seed) {
    std::mt19937_64 random(*options.seed);
    states->seedSamplers(random());
    actions->seedSamplers(random());
  }
  auto information = std::make_shared<ompl::control::SpaceInformation>(states, actions);
  information->setStatePropagator(std::make_shared<SymbolPropagator>(information));
  information->setStateValidityChecker(std::make_shared<SymbolValidity>(information));
  information->setMotionValidator(std::make_shared<ActionMotionValidator>(information));
  information->setPropagationStepSize(1);
  information->setMinMaxControlDuration(1, 1);
  information->setDirectedControlSamplerAllocator(
      [samples = options.control_samples](const ompl::control::SpaceInformation* space) {
        return std::make_shared<ompl::control::SimpleDirectedControlSampler>(space, samples);
      });
  information->setup();
  return information;
}

void setStartAndGoal(ompl::base::ProblemDefinition& problem) {
  const SymbolGraph& graph = statesOf(*problem.getSpaceInformation())->graph();
  const SymbolStateSpace::StateType start(graph.mostProbableStart());
  const SymbolStateSpace::StateType goal(graph.mostProbableGoal());
  problem.setStartAndGoalStates(&start, &goal);
}

}  // namespace conceptplan
