#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "report_markup.hpp"
#include "report_sections.hpp"
#include "report_symbols.hpp"

namespace conceptplan::report {
namespace {

// The symbols of one concept by falling probability; ties by number.
std::vector<std::size_t> ranked(const std::vector<double>& probabilities) {
  std::vector<std::size_t> order(probabilities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return probabilities[a] > probabilities[b];
  });
  return order;
}

// The most probable symbol with its confidence, and the next one where it is in question.
std::string beliefCell(const Report& report, const SymbolBelief& belief, Concept which,
                       bool differs) {
  const std::vector<double>& probabilities = belief[index(which)];
  const std::vector<std::size_t> order = ranked(probabilities);
  const auto symbol = [&](std::size_t rank) { return static_cast<SymbolId>(order[rank]); };
  std::string html = "<td data-label=\"" + std::string(heading(which)) + "\"" +
                     (differs ? " data-differs" : "") + "><span class=\"belief\">" +
                     colorKey(report, which, symbol(0)) + "<strong>" +
                     symbolName(report, which, symbol(0)) + "</strong> <small>" +
                     percent(probabilities[order[0]]) + "</small>" + bar(probabilities[order[0]]);
  constexpr double kInQuestion = 0.02;
  if (order.size() > 1 && probabilities[order[1]] >= kInQuestion) {
    html += "<span class=\"second\">or " + symbolName(report, which, symbol(1)) + " " +
            percent(probabilities[order[1]]) + "</span>";
  }
  return html + "</span></td>";
}

std::string table(const std::string& caption,
                  const std::vector<std::pair<std::string, std::string>>& rows) {
  if (rows.empty()) return {};
  std::string html = "<div class=\"card\"><table><caption>" + caption + "</caption><tbody>";
  for (const auto& [name, value] : rows) {
    html +=
        "<tr><th scope=\"row\">" + escaped(name) + "</th><td class=\"n\">" + value + "</td></tr>";
  }
  return html + "</tbody></table></div>";
}

std::vector<std::pair<std::string, std::string>> escapedValues(
    std::vector<std::pair<std::string, std::string>> rows) {
  for (auto& row : rows) row.second = escaped(row.second);
  return rows;
}

}  // namespace

std::string summarySection(const Report& report) {
  const PlanResult& result = report.result;
  const bool solved = result.status == PlanStatus::kSolved;
  std::string html = "<p class=\"lead\"><span class=\"status " +
                     std::string(solved ? "solved" : "unsolved") + "\">" +
                     std::string(name(result.status)) + "</span> ";
  if (!result.plans.empty()) {
    const Plan& best = result.plans.front();
    html += "The best plan takes " + std::to_string(best.actions.size()) +
            (best.actions.size() == 1 ? " action" : " actions") +
            " and reaches the goal with probability " + percent(best.probability) + ". ";
  }
  return html + reasonText(report) + (result.reason.empty() ? "" : " ") + escaped(report.verdict) +
         "</p>";
}

std::string alternativesSection(const Report& report) {
  const auto& plans = report.result.plans;
  if (plans.empty()) return {};
  std::string html =
      "<section><h2>All plans</h2><p class=\"note\">Distinct action sequences in order of the "
      "probability that they reach the goal's symbols.</p><div class=\"card scroll\">"
      "<table class=\"stack\"><thead><tr><th scope=\"col\">Plan</th><th scope=\"col\">Actions</th>"
      "<th scope=\"col\" class=\"n\">Length</th><th scope=\"col\">Probability</th>"
      "<th scope=\"col\" class=\"n\">Cost</th></tr></thead><tbody>";
  for (std::size_t i = 0; i < plans.size(); ++i) {
    html += "<tr><th scope=\"row\" data-label=\"Plan\">" + std::to_string(i + 1) +
            "</th><td data-label=\"Actions\"><span class=\"actions\">";
    for (std::size_t step = 0; step < plans[i].actions.size(); ++step) {
      const Action action = plans[i].actions[step];
      html += "<span>" + icon(action) + " " + movedName(report, plans[i], step) + words(action) +
              "</span>";
    }
    if (plans[i].actions.empty()) html += "none";
    html += "</span></td><td class=\"n\" data-label=\"Length\">" +
            std::to_string(plans[i].actions.size()) +
            "</td><td data-label=\"Probability\"><span class=\"belief\">" +
            percent(plans[i].probability) + bar(plans[i].probability) +
            "</span></td><td class=\"n\" data-label=\"Cost\">" + decimal(plans[i].cost, 2) +
            "</td></tr>";
  }
  return html + "</tbody></table></div></section>";
}

std::string symbolsSection(const Report& report) {
  const SymbolicScene& scene = report.problem.initial;
  std::string html =
      "<section><h2>What was read</h2><p class=\"note\">The symbols of each object with their "
      "probability. Of the target, also those of the goal picture; what the plan must change "
      "stands out.</p><div class=\"card scroll\"><table class=\"stack\"><thead><tr>"
      "<th scope=\"col\">Object</th>";
  for (const Concept which : kConcepts) {
    html += "<th scope=\"col\">" + std::string(heading(which)) + "</th>";
  }
  html += "</tr></thead><tbody>";
  const auto row = [&](const std::string& kind, const std::string& name, const SymbolBelief& belief,
                       const Symbols& other) {
    html += "<tr class=\"" + kind + "\"><th scope=\"row\">" + name + "</th>";
    for (const Concept which : kConcepts) {
      const bool differs = mostProbable(belief)[index(which)] != other[index(which)];
      html += beliefCell(report, belief, which, differs);
    }
    html += "</tr>";
  };
  for (const TargetGoal& target : targetsOf(report)) {
    const SymbolBelief& start = scene.objects[target.object];
    const std::string name = objectName(report, target.object);
    row("changes", name + "<span class=\"tag\">target</span>", start, mostProbable(target.goal));
    row("changes goal", name + "<span class=\"tag\">goal</span>", target.goal, mostProbable(start));
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (isTarget(report, i)) continue;
    row("", objectName(report, i), scene.objects[i], mostProbable(scene.objects[i]));
  }
  html += "</tbody></table></div>";
  for (const std::string& doubt : report.doubts) {
    html += "<p class=\"doubt\">" + escaped(doubt) + "</p>";
  }
  return html + "</section>";
}

std::string factsSection(const Report& report) {
  const double longest =
      std::accumulate(report.times_ms.begin(), report.times_ms.end(), 0.0,
                      [](double most, const auto& time) { return std::max(most, time.second); });
  std::vector<std::pair<std::string, std::string>> times;
  for (const auto& [name, time_ms] : report.times_ms) {
    times.emplace_back(name, decimal(time_ms, time_ms < 10 ? 2 : 0) + "&nbsp;ms" +
                                 bar(longest > 0 ? time_ms / longest : 0));
  }
  auto facts = escapedValues(report.facts);
  const SearchStatistics& statistics = report.result.statistics;
  facts.emplace_back("States expanded", std::to_string(statistics.expanded));
  facts.emplace_back("States generated", std::to_string(statistics.generated));
  facts.emplace_back("Validity checks", std::to_string(statistics.validity_checks));
  return "<section><h2>How it was found</h2><div class=\"facts\">" + table("Time", times) +
         table("Search", facts) + table("Versions", escapedValues(report.versions)) +
         "</div></section>";
}

}  // namespace conceptplan::report
