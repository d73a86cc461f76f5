#include "conceptplan/planners/pddl/determinisation.hpp"

#include <algorithm>
#include <cmath>

#include "option_range.hpp"

namespace conceptplan {

void checkDeterminisation(const Determinisation& determinisation) {
  checkOptionRange("legality_threshold", determinisation.legality_threshold, 0, 1);
  checkOptionRange("step_discount", determinisation.step_discount, 0, 0.5);
  checkOptionRange("cost_per_nat", static_cast<double>(determinisation.cost_per_nat), 1, 1e9);
}

std::int64_t wholeCost(const Transition& outcome, const Determinisation& determinisation) {
  const auto units = [&determinisation](double nats) {
    return std::llround(nats * static_cast<double>(determinisation.cost_per_nat));
  };
  return std::max(0LL, units(outcome.cost)) + units(-std::log1p(-determinisation.step_discount));
}

}  // namespace conceptplan
