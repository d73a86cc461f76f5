#include "rejection_counter.hpp"

#include <algorithm>

namespace conceptplan {

void RejectionCounter::add(const Rejection& rejection) {
  const auto [entry, is_new] = counts_.try_emplace(
      {rejection.cause, rejection.object},
      RejectionCount{rejection.cause, rejection.object, 0, rejection.value, rejection.value});
  RejectionCount& count = entry->second;
  ++count.steps;
  count.least = std::min(count.least, rejection.value);
  count.greatest = std::max(count.greatest, rejection.value);
}

std::vector<RejectionCount> RejectionCounter::counts() const {
  std::vector<RejectionCount> counts;
  for (const auto& entry : counts_) counts.push_back(entry.second);
  return counts;
}

}  // namespace conceptplan
