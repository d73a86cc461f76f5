#include "conceptplan/planners/plan_result.hpp"

namespace conceptplan {

std::string_view name(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kInfeasible:
      return "infeasible";
    case PlanStatus::kLimit:
      return "limit";
    case PlanStatus::kTimeout:
      return "timeout";
    case PlanStatus::kFailed:
      break;
  }
  return "failed";
}

}  // namespace conceptplan
