#include "conceptplan/planners/plan_result.hpp"

#include "conceptplan/domain/listed.hpp"

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

std::string explanation(const PlanResult& result, std::span<const std::string> names) {
  if (result.blocking.empty()) return result.reason;
  std::vector<std::string> objects;
  for (const std::size_t object : result.blocking) {
    objects.push_back(names.empty() ? "object " + std::to_string(object) : names[object]);
  }
  return result.reason + "; without " + listed(objects) + " there would be a way";
}

}  // namespace conceptplan
