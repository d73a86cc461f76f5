#pragma once

#include <array>
#include <vector>

#include "step_table.hpp"

namespace conceptplan {

/// When one action was taken, and the counts {other action, this action} behind each factor.
struct LegalityEstimate {
  std::vector<LegalityFactor> factors;
  std::vector<ContextCounts> counts;
};

/// @param misread_rate of the symbols of each concept, in [0, 1].
LegalityEstimate estimateLegality(const StepTable& table, Action action,
                                  const std::array<double, kNumConcepts>& misread_rate,
                                  const TransitionEstimationOptions& options);

}  // namespace conceptplan
