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
  const std::string way = report.targets.empty()
                              ? " there would be a way"
                              : " there would be a way for each target, were the others not there";
  return paragraph("Without " + listed(names) + way +
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

/// "Cup 2: " where there are several targets.
std::string targetPrefix(const Report& report, const TargetGoal& target) {
  return report.targets.empty() ? "" : objectName(report, target.object) + ": ";
}

std::string nearestSentences(const Report& report) {
  std::string html;
  const std::vector<TargetGoal> targets = targetsOf(report);
  for (std::size_t i = 0; i < report.result.nearest.size(); ++i) {
    const std::string missed =
        differences(report, report.result.nearest[i], mostProbable(targets[i].goal));
    if (missed.empty()) continue;
    html += paragraph(targetPrefix(report, targets[i]) +
                      "The nearest to the goal that is in reach has " + missed + ".");
  }
  return html;
}

std::string nearestTable(const Report& report) {
  std::string html =
      "<div class=\"scroll\"><table class=\"stack\"><thead><tr><th scope=\"col\">Target</th>";
  for (const Concept which : kConcepts) {
    html += "<th scope=\"col\">" + std::string(heading(which)) + "</th>";
  }
  html += "</tr></thead><tbody>";
  const std::vector<TargetGoal> targets = targetsOf(report);
  for (std::size_t i = 0; i < report.result.nearest.size(); ++i) {
    const Symbols start = mostProbable(report.problem.initial.objects[targets[i].object]);
    const Symbols goal = mostProbable(targets[i].goal);
    const std::string of = targetPrefix(report, targets[i]);
    html += row(report, of + "Start", start, goal) +
            row(report, of + "Nearest in reach", report.result.nearest[i], goal) +
            row(report, of + "Goal", goal, goal);
  }
  return html + "</tbody></table></div>";
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
  html += nearestSentences(report);
  if (html.empty()) html = paragraph(reasonText(report));
  html += rejectionSentence(report);
  if (!result.nearest.empty()) html += nearestTable(report);
  return "<div class=\"card why\">" + html + "</div>";
}

}  // namespace conceptplan::report
