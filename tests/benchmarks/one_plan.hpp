#pragma once

#include <benchmark/benchmark.h>

#include "conceptplan/planners/planner.hpp"

namespace conceptplan::testing {

inline constexpr std::size_t kLongestPlan = 100'000;

/// One plan, without a limit that a benchmark meets.
inline PlanQuery onePlan() {
  PlanQuery query;
  query.top = 1;
  query.limits = {1e6, 1'000'000'000, kLongestPlan, nullptr};
  return query;
}

/// Whether there is a plan; if not, the benchmark fails for the planner's reason.
inline bool isSolved(const PlanResult& result, benchmark::State& state) {
  if (result.status == PlanStatus::kSolved) return true;
  state.SkipWithError(result.reason.c_str());
  return false;
}

}  // namespace conceptplan::testing
