#pragma once

#include "conceptplan/pipeline/solve.hpp"
#include "console.hpp"

namespace conceptplan::cli {

/// What was ruled out on the way to the answer and, where there is none, what is in the way and how
/// near the target gets, as docs/command.md describes it.
Json traceJson(const Solution& solution);

}  // namespace conceptplan::cli
