#pragma once

#include "conceptplan/pipeline/report.hpp"

namespace conceptplan {

/// A solved task with everything that a report can show: a cup that goes around a pot to the dyer
/// and on to its goal, with synthetic pictures.
Report sampleReport();

}  // namespace conceptplan
