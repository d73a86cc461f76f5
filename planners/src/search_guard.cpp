#include "conceptplan/planners/search_guard.hpp"

#include <algorithm>

namespace conceptplan {
namespace {

constexpr double kLongestTimeout_s = 1e6;

}  // namespace

SearchGuard::SearchGuard(const SearchLimits& limits)
    : limits_(limits),
      deadline_(std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                    std::chrono::duration<double>(std::min(limits.timeout_s, kLongestTimeout_s)))) {
}

bool SearchGuard::goesOn(const SearchStatistics& statistics) {
  if (stopped_) return false;
  if (limits_.cancel != nullptr && limits_.cancel->load(std::memory_order_relaxed)) {
    stop(PlanStatus::kLimit, "cancelled");
  } else if (statistics.expanded >= limits_.max_expansions) {
    stop(PlanStatus::kLimit,
         "stopped at the limit of " + std::to_string(limits_.max_expansions) + " expansions");
  } else if (statistics.expanded % kClockInterval == 0 &&
             std::chrono::steady_clock::now() >= deadline_) {
    stop(PlanStatus::kTimeout,
         "stopped at the time limit of " + std::to_string(limits_.timeout_s) + " s");
  }
  return !stopped_;
}

void SearchGuard::stop(PlanStatus status, std::string reason) {
  stopped_ = status;
  reason_ = std::move(reason);
}

}  // namespace conceptplan
