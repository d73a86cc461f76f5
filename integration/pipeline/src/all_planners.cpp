#include "conceptplan/pipeline/all_planners.hpp"

#include "conceptplan/planners/pddl/fast_downward_planner.hpp"
#ifdef CONCEPTPLAN_WITH_OMPL
#include "conceptplan/ompl/ompl_planner.hpp"
#endif

namespace conceptplan {

PlannerRegistry allPlanners() {
  PlannerRegistry registry = PlannerRegistry::standard();
#ifdef CONCEPTPLAN_WITH_OMPL
  addOmplPlanners(registry);
#endif
  addFastDownwardPlanner(registry);
  return registry;
}

}  // namespace conceptplan
