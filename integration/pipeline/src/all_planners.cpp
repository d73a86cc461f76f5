#include "conceptplan/pipeline/all_planners.hpp"

#ifdef CONCEPTPLAN_WITH_OMPL
#include "conceptplan/ompl/ompl_planner.hpp"
#endif

namespace conceptplan {

PlannerRegistry allPlanners() {
  PlannerRegistry registry = PlannerRegistry::standard();
#ifdef CONCEPTPLAN_WITH_OMPL
  addOmplPlanners(registry);
#endif
  return registry;
}

}  // namespace conceptplan
