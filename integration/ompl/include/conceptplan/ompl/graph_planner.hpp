#pragma once

#include <ompl/base/Planner.h>
#include <ompl/control/SpaceInformation.h>

#include <memory>
#include <string>

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

/// A planner of ours as one of OMPL: for `ompl::control::SimpleSetup` and `ompl::tools::Benchmark`.
/// Plans from each valid start state of the problem definition to each state of its goal, until a
/// plan's path is an exact solution: its most probable outcomes end in the goal. What else it finds
/// are approximate solutions; a path ends before a step that the space does not allow. The states
/// of a GoalState or GoalStates are all within its threshold, nearest first; any other region is
/// sampled.
///
/// Where the planner proves for each start and each state of a GoalState or GoalStates that there
/// is no plan within the horizon, and no number of steps of the space leads to the goal either, the
/// definition gets a proof of that, and the status is INFEASIBLE (ABORT in versions of OMPL that
/// lack it). What is not proved is TIMEOUT.
///
/// The termination condition takes the place of the query's time limit and cancel flag; it is
/// evaluated in the calling thread, once a millisecond while the planner searches. The other limits
/// are the parameters `max_expansions`, `horizon` and `seed`; each pair of start and goal has them
/// to itself.
class GraphPlanner final : public ompl::base::Planner {
 public:
  /// @param space by `makeSpaceInformation`
  /// @param query its `source`, if any, must outlive the planner; with a greater `top` the next
  /// plans are tried where a check of motions denies one
  /// @throws std::invalid_argument if the planner is null or the space is of another kind.
  GraphPlanner(const ompl::control::SpaceInformationPtr& space,
               std::shared_ptr<const conceptplan::Planner> planner, const std::string& name,
               const PlanQuery& query = {.top = 1});

  ompl::base::PlannerStatus solve(
      const ompl::base::PlannerTerminationCondition& termination) override;
  using ompl::base::Planner::solve;

  /// Of the last start and goal that the last call of `solve` tried.
  const PlanResult& result() const { return result_; }

 private:
  std::shared_ptr<const conceptplan::Planner> planner_;
  PlanQuery query_;
  PlanResult result_;
};

}  // namespace conceptplan
