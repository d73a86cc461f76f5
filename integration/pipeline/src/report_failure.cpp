#include <algorithm>
#include <string>
#include <vector>

#include "conceptplan/domain/listed.hpp"
#include "report_markup.hpp"
#include "report_sections.hpp"
#include "report_symbols.hpp"

namespace conceptplan::report {
namespace {

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>"; }

std::string strong(const std::string& html) { return "<strong>" + html + "</strong>"; }

std::string blockingSentence(const Report& report) {
  const std::vector<std::size_t>& blocking = report.result.blocking;
  if (blocking.empty()) return {};
  std::vector<std::string> names;
  for (const std::size_t object : blocking) names.push_back(strong(objectName(report, object)));
  return paragraph("Without " + listed(names) + " there would be a way" +
                   (blocking.size() > 1 ? "; without fewer objects there would be none." : "."));
}

/// "row 0 in place of row 4", for each concept in which two states differ.
std::string differences(const Report& report, const Symbols& found, const Symbols& wanted) {
  std::vector<std::string> texts;
  for (const Concept which : kConcepts) {
    const SymbolId here = found[index(which)];
    const SymbolId there = wanted[index(which)];
    if (here == there) continue;
    texts.push_back(symbolName(report, which, here) + " in place of " +
                    strong(symbolName(report, which, there)));
  }
  return listed(texts);
}

std::string row(const Report& report, const std::string& title, const Symbols& symbols,
                const Symbols& goal) {
  std::string html = "<tr class=\"changes\"><th scope=\"row\">" + title + "</th>";
  for (const Concept which : kConcepts) {
    const SymbolId symbol = symbols[index(which)];
    html += "<td data-label=\"" + std::string(heading(which)) + "\"" +
            (symbol != goal[index(which)] ? " data-differs" : "") + "><span>" +
            colorKey(report, which, symbol) + strong(symbolName(report, which, symbol)) +
            "</span></td>";
  }
  return html + "</tr>";
}

std::string nearestTable(const Report& report) {
  const Symbols goal = mostProbable(report.problem.goal);
  std::string html =
      "<div class=\"scroll\"><table class=\"stack\"><thead><tr><th scope=\"col\">Target</th>";
  for (const Concept which : kConcepts) {
    html += "<th scope=\"col\">" + std::string(heading(which)) + "</th>";
  }
  const SymbolicScene& scene = report.problem.initial;
  return html + "</tr></thead><tbody>" +
         row(report, "Start", mostProbable(scene.objects[scene.target]), goal) +
         row(report, "Nearest in reach", *report.result.nearest, goal) +
         row(report, "Goal", goal, goal) + "</tbody></table></div>";
}

std::string rejectionSentence(const Report& report) {
  std::vector<std::string> parts;
  const auto add = [&](Invalidity cause, const std::string& what) {
    const auto times = std::ranges::count(report.result.rejections, cause, &Rejection::cause);
    if (times > 0) parts.push_back(std::to_string(times) + " " + what);
  };
  add(Invalidity::kNone, "by the action threshold");
  add(Invalidity::kCollision, "by collision");
  add(Invalidity::kWorkbenchEdge, "by the edge of the workbench");
  add(Invalidity::kCheckFailed, "since the collision check failed");
  return parts.empty() ? "" : paragraph("Steps ruled out around the start: " + listed(parts) + ".");
}

}  // namespace

std::string failureCard(const Report& report) {
  const PlanResult& result = report.result;
  std::string html = blockingSentence(report);
  if (result.nearest) {
    const std::string missed =
        differences(report, *result.nearest, mostProbable(report.problem.goal));
    if (!missed.empty()) {
      html += paragraph("The nearest to the goal that is in reach has " + missed + ".");
    }
  }
  if (html.empty()) html = paragraph(reasonText(report));
  html += rejectionSentence(report);
  if (result.nearest) html += nearestTable(report);
  return "<div class=\"card why\">" + html + "</div>";
}

}  // namespace conceptplan::report
