#pragma once

#include <ompl/base/Planner.h>
#include <ompl/control/SpaceInformation.h>

#include <memory>
#include <string>

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

/// A planner of ours as one of OMPL: for `ompl::control::SimpleSetup` and `ompl::tools::Benchmark`.
/// Plans from the first start state of the problem definition to a state sampled from its goal, and
/// adds the plan's path, an exact solution if the most probable outcomes end in the goal. Where the
/// planner proves that there is no plan, the definition gets a proof of that, and the status is
/// INFEASIBLE (ABORT in versions of OMPL that lack it).
///
/// The termination condition takes the place of the query's time limit and cancel flag; it is
/// evaluated once a millisecond in the calling thread. The other limits are the parameters
/// `max_expansions`, `horizon` and `seed`.
class GraphPlanner final : public ompl::base::Planner {
 public:
  /// @param space by `makeSpaceInformation`
  /// @throws std::invalid_argument if the planner is null or the space is of another kind.
  GraphPlanner(const ompl::control::SpaceInformationPtr& space,
               std::shared_ptr<const conceptplan::Planner> planner, const std::string& name,
               const PlanQuery& query = {});

  ompl::base::PlannerStatus solve(
      const ompl::base::PlannerTerminationCondition& termination) override;
  using ompl::base::Planner::solve;

  /// Of the last call of `solve`.
  const PlanResult& result() const { return result_; }

 private:
  std::shared_ptr<const conceptplan::Planner> planner_;
  PlanQuery query_;
  PlanResult result_;
};

}  // namespace conceptplan
