#include "conceptplan/planners/state_path.hpp"

#include <cmath>

namespace conceptplan {

PathCost toPathCost(double nats) { return std::llround(nats * static_cast<double>(kNat)); }

double toNats(PathCost cost) { return static_cast<double>(cost) / static_cast<double>(kNat); }

}  // namespace conceptplan
