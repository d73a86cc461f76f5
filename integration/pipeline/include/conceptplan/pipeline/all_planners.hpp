#pragma once

#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {

/// The planners of this build by name: the standard ones, and those of OMPL where it is built with
/// the component `ompl`.
PlannerRegistry allPlanners();

}  // namespace conceptplan
