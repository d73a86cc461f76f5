#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "conceptplan/domain/listed.hpp"
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

std::string millimetres(double length_m) { return decimal(1000 * length_m, 0); }

// "35 to 47 mm" or "up to 47 mm": how far steps of which the lowest clearance is below 0 overlap.
std::string depth(double lowest, double highest) {
  const std::string most = millimetres(-lowest) + "&nbsp;mm";
  if (highest >= 0) return "up to " + most;
  const std::string least = millimetres(-highest) + "&nbsp;mm";
  return least == most ? most : millimetres(-highest) + " to " + most;
}

std::string collisionText(const Group& group) {
  if (group.lowest < 0)
    return " would bring the target " + depth(group.lowest, group.highest) + " deep into it.";
  if (group.lowest > 0) {
    return " would bring the target to within " + decimal(1000 * group.lowest, 1) +
           "&nbsp;mm of it.";
  }
  return " would bring the target into it.";  // not measured, or exactly touching
}

std::string explanation(const Report& report, const Reason& reason, const Group& group) {
  const std::string times = std::to_string(group.count) + (group.count == 1 ? " step" : " steps");
  switch (std::get<0>(reason)) {
    case Invalidity::kNone:
      return times + ": the training data take this action there in " + percent(group.highest) +
             " of the cases at most" +
             (report.legality_threshold
                  ? "; more than " + percent(*report.legality_threshold) + " are needed."
                  : ".");
    case Invalidity::kCollision:
      return times + collisionText(group);
    case Invalidity::kWorkbenchEdge:
      return times + " would bring part of the target over the edge" +
             (group.lowest < 0 ? ", by " + depth(group.lowest, group.highest) : "") + ".";
    case Invalidity::kCheckFailed:
      return times + " counted as impossible, since geometry could not be decided.";
  }
  return {};
}

// In what the state of a target before a step differs from the start.
std::string placeOf(const Report& report, const Rejection& rejection) {
  const SymbolicScene& scene = report.problem.initial;
  const Symbols start = mostProbable(scene.objects[rejection.moved.value_or(scene.target)]);
  std::vector<std::string> texts;
  for (const Concept which : kConcepts) {
    const SymbolId symbol = rejection.state[index(which)];
    if (symbol != start[index(which)]) texts.push_back(symbolName(report, which, symbol));
  }
  return (rejection.moved ? objectName(report, *rejection.moved) + ": " : "") +
         (texts.empty() ? "as at the start" : listed(texts));
}

std::string causeOf(const Report& report, Invalidity cause, std::optional<std::size_t> object) {
  switch (cause) {
    case Invalidity::kNone:
      return "action threshold";
    case Invalidity::kCollision:
      return "collision with " + objectName(report, object.value_or(0));
    case Invalidity::kWorkbenchEdge:
      return "edge of the workbench";
    case Invalidity::kCheckFailed:
      return "failed check";
  }
  return {};
}

std::string measureOf(const Rejection& rejection) {
  if (rejection.cause == Invalidity::kNone) return percent(rejection.value);
  if (rejection.value == 0) return {};
  const std::string length = decimal(1000 * std::abs(rejection.value), 1) + "&nbsp;mm";
  return rejection.value < 0 ? length + " deep" : length + " away";
}

std::string everyRejection(const Report& report) {
  const auto& rejections = report.result.rejections;
  std::string html =
      "<details class=\"card scroll every\"><summary>Every step (" +
      std::to_string(rejections.size()) +
      ")</summary><table><thead><tr><th scope=\"col\">Target</th><th scope=\"col\">Action</th>"
      "<th scope=\"col\">Ruled out by</th><th scope=\"col\" class=\"n\">Measure</th></tr></thead>"
      "<tbody>";
  for (const Rejection& rejection : rejections) {
    html += "<tr><td>" + placeOf(report, rejection) + "</td><td>" + icon(rejection.action) + " " +
            words(rejection.action) + "</td><td>" +
            causeOf(report, rejection.cause, rejection.object) + "</td><td class=\"n\">" +
            measureOf(rejection) + "</td></tr>";
  }
  return html + "</tbody></table></details>";
}

// What was ruled out over the whole search, by cause.
std::string searchTable(const Report& report) {
  if (!report.result.ruled_out) return {};
  const RejectionTally& tally = *report.result.ruled_out;
  std::string html =
      "<p class=\"note\">Over all " + std::to_string(tally.states) +
      (tally.states == 1 ? " state" : " states") +
      " that the search expanded:</p><div class=\"card scroll\"><table class=\"search\"><thead>"
      "<tr><th scope=\"col\">Ruled out by</th><th scope=\"col\" class=\"n\">Steps</th>"
      "<th scope=\"col\" class=\"n\">Measure</th></tr></thead><tbody>";
  for (const RejectionCount& count : tally.counts) {
    const bool by_legality = count.cause == Invalidity::kNone;
    const std::string measure = by_legality       ? percent(count.greatest) + " at most"
                                : count.least < 0 ? depth(count.least, count.greatest) + " deep"
                                                  : "";
    html += "<tr><td>" + causeOf(report, count.cause, count.object) + "</td><td class=\"n\">" +
            std::to_string(count.steps) + "</td><td class=\"n\">" + measure + "</td></tr>";
  }
  return html + "</tbody></table></div>";
}

std::string rejectionCards(const Report& report) {
  if (report.result.rejections.empty()) return {};
  std::string html =
      "<p class=\"note\">Steps " +
      std::string(report.result.plans.empty() ? "around the start" : "beside the best plan") +
      " that a legality check refused. Each small map shows where the target stood: the darker "
      "the cell, the more steps.</p><div class=\"reasons\">";
  for (const auto& [reason, group] : grouped(report)) {
    html += "<article class=\"card\">" + heatMap(report.problem.initial.workbench, group.per_cell) +
            "<div><h3>" + headingOf(report, reason) + "</h3><p>" +
            explanation(report, reason, group) + "</p></div></article>";
  }
  return html + "</div>" + everyRejection(report);
}

}  // namespace

std::string rejectionsSection(const Report& report) {
  const std::string html = rejectionCards(report) + searchTable(report);
  if (html.empty()) return {};
  return "<section><h2>What was ruled out, and why</h2>" + html + "</section>";
}

}  // namespace conceptplan::report
