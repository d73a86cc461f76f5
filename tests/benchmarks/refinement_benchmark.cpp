// Refinement of 1,000 planned motions of each of the levels 2 to 4: milliseconds of the processor a
// plan, share of fallbacks, and whether FCL finds every refined one clear at steps of 1 mm. The
// product's bounds: median 10 ms, fallbacks 2 %, none found unclear or longer than its plan. Fails
// where one of them but the time is missed.
// refinement_benchmark [TASKS] [ALGORITHM] [CLEARANCE_M]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "conceptplan/nlopt/refiner.hpp"
#include "integration/nlopt/motion_worlds.hpp"

namespace conceptplan {
namespace {

/// Whether the bounds are kept.
bool refineLevel(int level, int tasks, const RefinementOptions& options) {
  const Refiner refiner(options);
  std::vector<double> times_ms;
  int fallbacks = 0;
  int unclear = 0;
  int longer = 0;
  int lifted = 0;
  double length_share = 0;
  double jerk_share = 0;
  std::string reason;
  for (int i = 0; i < tasks; ++i) {
    const MotionTask task = testing::plannedMotion(level, i);
    const std::clock_t start = std::clock();
    const RefinementResult result = refiner.refine(task);
    times_ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (result.fell_back) {
      ++fallbacks;
      reason = result.reason;
      continue;
    }
    unclear += !testing::isClear(task, result.trajectory, options.clearance_m);
    longer += result.length_m > result.discrete_length_m + 1e-6;
    lifted += result.lift_m > 0;
    length_share += result.length_m / result.discrete_length_m;
    jerk_share += result.squared_jerk / squaredJerk(discreteTrajectory(task, options.action_s));
  }
  std::sort(times_ms.begin(), times_ms.end());
  const auto refined = std::max(1, tasks - fallbacks);
  std::printf(
      "level %d: %d tasks, median %.2f ms, 99 %% %.2f ms, most %.2f ms; fallbacks %d, lifted %d, "
      "unclear %d, longer %d; length %.3f and squared jerk %.3f of the discrete plan's\n",
      level, tasks, times_ms[times_ms.size() / 2], times_ms[times_ms.size() * 99 / 100],
      times_ms.back(), fallbacks, lifted, unclear, longer, length_share / refined,
      jerk_share / refined);
  if (!reason.empty()) std::printf("  last fallback: %s\n", reason.c_str());
  const bool kept = unclear == 0 && longer == 0 && fallbacks <= 0.02 * tasks;
  if (!kept) std::printf("  the bounds are missed\n");
  return kept;
}

}  // namespace
}  // namespace conceptplan

int main(int count, char** arguments) {
  conceptplan::RefinementOptions options;
  const int tasks = count > 1 ? std::atoi(arguments[1]) : 1000;
  if (count > 2) options.algorithm = arguments[2];
  if (count > 3) options.clearance_m = std::atof(arguments[3]);
  bool kept = true;
  for (int level = 2; level <= 4; ++level) {
    kept = conceptplan::refineLevel(level, tasks, options) && kept;
  }
  return kept ? EXIT_SUCCESS : EXIT_FAILURE;
}
