#pragma once

#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {

/// The planners of this build by name: the standard ones, those of OMPL where it is built with the
/// component `ompl`, and `fast-downward` where that program is on the PATH.
PlannerRegistry allPlanners();

}  // namespace conceptplan
