#include "report_symbols.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "conceptplan/pipeline/object_name.hpp"
#include "report_markup.hpp"

namespace conceptplan::report {

std::string_view heading(Concept which) {
  static constexpr std::array<std::string_view, kNumConcepts> kHeadings{
      "Type", "Column", "Row", "Rotation", "Color", "Size"};
  return kHeadings[index(which)];
}

std::string reasonText(const Report& report) {
  std::string text = report.result.reason;
  for (const Concept which : kConcepts) {
    const std::string_view told = name(which);
    std::string word(heading(which));
    word.front() += 'a' - 'A';
    for (std::size_t at = text.find(told); at != std::string::npos;
         at = text.find(told, at + word.size())) {
      text.replace(at, told.size(), word);
    }
  }
  return sentence(text);
}

std::string symbolName(const Report& report, Concept which, SymbolId symbol) {
  return escaped(report.grounding.name(which, symbol));
}

std::string_view cssColor(std::string_view color_name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kColors{
      {{"red", "#c8453b"},
       {"yellow", "#dcb53c"},
       {"green", "#4f9d52"},
       {"cyan", "#45adb8"},
       {"blue", "#446cc4"},
       {"magenta", "#b54c9f"}}};
  const auto found = std::find_if(kColors.begin(), kColors.end(),
                                  [&](const auto& color) { return color.first == color_name; });
  return found == kColors.end() ? std::string_view{} : found->second;
}

std::string colorKey(const Report& report, Concept which, SymbolId symbol) {
  if (which != Concept::kColor) return {};
  const std::string_view color = cssColor(symbolName(report, which, symbol));
  if (color.empty()) return {};
  return "<span class=\"key\" aria-hidden=\"true\" style=\"background:" + std::string(color) +
         "\"></span>";
}

int instance(const Report& report, std::size_t object) {
  return report.instances.empty() ? static_cast<int>(object + 1) : report.instances[object];
}

std::string objectName(const Report& report, std::size_t object) {
  return escaped(conceptplan::objectName(report.grounding, report.problem.initial.objects[object],
                                         instance(report, object)));
}

std::vector<TargetGoal> targetsOf(const Report& report) {
  if (!report.targets.empty()) return report.targets;
  return {{report.problem.initial.target, report.problem.goal}};
}

bool isTarget(const Report& report, std::size_t object) {
  return std::ranges::any_of(
      targetsOf(report), [object](const TargetGoal& target) { return target.object == object; });
}

std::size_t movedObject(const Report& report, const Plan& plan, std::size_t step) {
  return plan.moved.empty() ? report.problem.initial.target : plan.moved[step];
}

std::string movedName(const Report& report, const Plan& plan, std::size_t step) {
  return plan.moved.empty() ? "" : objectName(report, plan.moved[step]) + ": ";
}

std::string words(Action action) {
  std::string text(name(action));
  std::replace(text.begin(), text.end(), '_', ' ');
  return escaped(text);
}

std::string icon(Action action) {
  return "<svg class=\"icon\" aria-hidden=\"true\" focusable=\"false\"><use href=\"#" +
         std::string(name(action)) + "\"/></svg>";
}

}  // namespace conceptplan::report
