#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "report_markup.hpp"
#include "report_sections.hpp"
#include "report_symbols.hpp"

namespace conceptplan::report {
namespace {

// What rejections have in common: the cause, then the action (of an illegal action) or the object
// (of a collision).
using Reason = std::tuple<Invalidity, std::size_t>;

struct Group {
  std::vector<std::size_t> per_cell;  // [rows][columns], of the target before the action
  std::size_t count = 0;
  double lowest = 0;
  double highest = 0;
};

Reason reasonOf(const Rejection& rejection) {
  switch (rejection.cause) {
    case Invalidity::kNone:
      return {rejection.cause, index(rejection.action)};
    case Invalidity::kCollision:
      return {rejection.cause, rejection.object.value_or(0)};
    default:
      return {rejection.cause, 0};
  }
}

std::map<Reason, Group> grouped(const Report& report) {
  const Workbench& bench = report.problem.initial.workbench;
  std::map<Reason, Group> groups;
  for (const Rejection& rejection : report.result.rejections) {
    const auto [entry, is_new] = groups.try_emplace(reasonOf(rejection));
    Group& group = entry->second;
    if (is_new) {
      group.per_cell.assign(static_cast<std::size_t>(bench.columns * bench.rows), 0);
      group.lowest = group.highest = rejection.value;
    }
    const Cell cell = report.grounding.cell(rejection.state);
    if (bench.contains(cell)) {
      ++group.per_cell[static_cast<std::size_t>(cell.y * bench.columns + cell.x)];
    }
    ++group.count;
    group.lowest = std::min(group.lowest, rejection.value);
    group.highest = std::max(group.highest, rejection.value);
  }
  return groups;
}

std::string headingOf(const Report& report, const Reason& reason) {
  const auto [cause, which] = reason;
  switch (cause) {
    case Invalidity::kNone:
      return icon(kActions[which]) + " " + words(kActions[which]) + " is not legal";
    case Invalidity::kCollision:
      return "Collision with " + objectName(report, which);
    case Invalidity::kWorkbenchEdge:
      return "Beyond the workbench";
    case Invalidity::kCheckFailed:
      return "The collision check failed";
  }
  return {};
}

std::string explanation(const Report& report, const Reason& reason, const Group& group) {
  const std::string times = std::to_string(group.count) + (group.count == 1 ? " step" : " steps");
  switch (std::get<0>(reason)) {
    case Invalidity::kNone:
      return times + ": the training data take this action there in at most " +
             percent(group.highest) + " of the cases" +
             (report.legality_threshold
                  ? "; more than " + percent(*report.legality_threshold) + " are needed."
                  : ".");
    case Invalidity::kCollision:
      return times + " would bring the target into it.";
    case Invalidity::kWorkbenchEdge:
      return times + " would bring part of the target over the edge.";
    case Invalidity::kCheckFailed:
      return times + " counted as impossible, since geometry could not be decided.";
  }
  return {};
}

}  // namespace

std::string rejectionsSection(const Report& report) {
  if (report.result.rejections.empty()) return {};
  std::string html =
      "<section><h2>What was ruled out, and why</h2><p class=\"note\">Steps " +
      std::string(report.result.plans.empty() ? "around the start" : "beside the best plan") +
      " that a legality check refused. Each small map shows where the target stood: the darker "
      "the cell, the more steps.</p><div class=\"reasons\">";
  for (const auto& [reason, group] : grouped(report)) {
    html += "<article class=\"card\">" + heatMap(report.problem.initial.workbench, group.per_cell) +
            "<div><h3>" + headingOf(report, reason) + "</h3><p>" +
            explanation(report, reason, group) + "</p></div></article>";
  }
  return html + "</div></section>";
}

}  // namespace conceptplan::report
