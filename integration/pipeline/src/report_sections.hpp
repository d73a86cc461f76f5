#pragma once

#include <string>
#include <vector>

#include "conceptplan/pipeline/report.hpp"

namespace conceptplan::report {

// Each part of the page as HTML; empty where the report has nothing to show. All take a report
// that `renderReport` has checked.

/// Status and one sentence.
std::string summarySection(const Report& report);
/// The two pictures with outlined masks.
std::string picturesSection(const Report& report);
/// The best plan: a map and a frame a step.
std::string planSection(const Report& report);
/// Why there is no plan, how near the target gets and what was ruled out, in sentences.
std::string failureCard(const Report& report);
/// All plans, with their probabilities.
std::string alternativesSection(const Report& report);
/// What was read of every object, with confidence.
std::string symbolsSection(const Report& report);
/// Why states and actions were refused, by reason.
std::string rejectionsSection(const Report& report);
/// Times, statistics and versions.
std::string factsSection(const Report& report);

/// The workbench from above as SVG: objects, the target's path and its goal. The far row is on top.
std::string workbenchMap(const Report& report);
/// A small workbench whose cells are darker the more often the target was refused there.
/// @param counts [rows][columns], row-major from row 0
std::string heatMap(const Workbench& workbench, const std::vector<std::size_t>& counts);

}  // namespace conceptplan::report
