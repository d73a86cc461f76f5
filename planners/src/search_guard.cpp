#include "conceptplan/planners/search_guard.hpp"

#include <algorithm>

namespace conceptplan {
namespace {

constexpr double kLongestTimeout_s = 1e6;

}  // namespace

SearchGuard::SearchGuard(const SearchLimits& limits, std::vector<bool>* expanded)
    : limits_(limits),
      expanded_(expanded),
      deadline_(std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                    std::chrono::duration<double>(std::min(limits.timeout_s, kLongestTimeout_s)))) {
}

bool SearchGuard::mayGoOn() {
  if (stopped_) return false;
  if (isCancelled()) {
    stop(PlanStatus::kLimit, "cancelled");
  } else if (asked_ % kClockInterval == 1) {
    stopIfLate();
  }
  return !stopped_;
}

bool SearchGuard::mayExpand(const SearchStatistics& statistics) {
  if (stopped_) return false;
  if (isCancelled()) {
    stop(PlanStatus::kLimit, "cancelled");
  } else if (statistics.expanded >= limits_.max_expansions) {
    stopAtLimit();
  } else if (statistics.expanded % kClockInterval == 0) {
    stopIfLate();
  }
  return !stopped_;
}

bool SearchGuard::leaves(std::size_t expansions, const SearchStatistics& statistics) {
  if (stopped_) return false;
  if (limits_.max_expansions - statistics.expanded < expansions) stopAtLimit();
  return !stopped_;
}

bool SearchGuard::hasTime() const { return !isCancelled() && !isLate(); }

bool SearchGuard::isCancelled() const {
  return limits_.cancel != nullptr && limits_.cancel->load(std::memory_order_relaxed);
}

bool SearchGuard::isLate() const { return std::chrono::steady_clock::now() >= deadline_; }

void SearchGuard::stopIfLate() {
  if (!isLate()) return;
  stop(PlanStatus::kTimeout,
       "stopped at the time limit of " + std::to_string(limits_.timeout_s) + " s");
}

void SearchGuard::stopAtLimit() {
  stop(PlanStatus::kLimit,
       "stopped at the limit of " + std::to_string(limits_.max_expansions) + " expansions");
}

void SearchGuard::stop(PlanStatus status, std::string reason) {
  stopped_ = status;
  reason_ = std::move(reason);
}

}  // namespace conceptplan
