#pragma once

#include <vector>

#include "step_table.hpp"

namespace conceptplan {

/// What the steps of one action tell of one concept.
struct EffectEstimate {
  Effect effect;
  ContextCounts counts;
  double steps = 0;    ///< seen
  double misread = 0;  ///< of them, outcomes that were taken for misread symbols
};

/// @param steps numbers of the action's steps in the table.
EffectEstimate estimateEffect(const StepTable& table, const std::vector<std::size_t>& steps,
                              Concept which, const TransitionEstimationOptions& options);

}  // namespace conceptplan
