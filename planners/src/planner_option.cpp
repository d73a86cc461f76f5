#include "conceptplan/planners/planner_option.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "conceptplan/domain/files/nearest_name.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

std::string shortText(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::optional<double> numberIn(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

PlannerOption PlannerOption::number(std::string name, std::string standard, double least,
                                    double most, std::string summary) {
  return {std::move(name),   OptionType::kNumber, std::move(standard), least, most, {},
          std::move(summary)};
}

PlannerOption PlannerOption::integer(std::string name, std::string standard, double least,
                                     double most, std::string summary) {
  return {std::move(name),   OptionType::kInteger, std::move(standard), least, most, {},
          std::move(summary)};
}

PlannerOption PlannerOption::choice(std::string name, std::vector<std::string> choices,
                                    std::string summary) {
  std::string standard = choices.front();
  return {std::move(name),    OptionType::kChoice, std::move(standard), 0, 0,
          std::move(choices), std::move(summary)};
}

PlannerOption PlannerOption::legalityThreshold() {
  return number("legality_threshold", "0.01", 0, 1,
                "an action is legal where Pr[a given the symbols] is greater");
}

PlannerOption PlannerOption::stepDiscount(double least) {
  return number("step_discount", "0.01", least, 0.5,
                "share by which one more action must raise a plan's probability to rank first");
}

std::string PlannerOption::typeName() const {
  switch (type) {
    case OptionType::kNumber:
      return "number";
    case OptionType::kInteger:
      return "integer";
    case OptionType::kChoice:
      break;
  }
  return "choice";
}

std::string PlannerOption::range() const {
  if (type != OptionType::kChoice) return "[" + shortText(least) + ", " + shortText(most) + "]";
  std::string text;
  for (const std::string& choice : choices) text += (text.empty() ? "" : " | ") + choice;
  return text;
}

OptionValues::OptionValues(const std::vector<PlannerOption>& options, const OptionTexts& texts,
                           const std::string& path) {
  std::vector<Fault> faults;
  std::vector<std::string_view> known;
  for (const PlannerOption& option : options) known.push_back(option.name);
  for (const auto& [name, text] : texts) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      faults.push_back(
          {path, {}, {}, "planner.options." + name, "unknown option" + didYouMean(name, known)});
    }
  }
  for (const PlannerOption& option : options) {
    const auto given = texts.find(option.name);
    const std::string& text = given == texts.end() ? option.standard : given->second;
    const auto wrong = [&] {
      faults.push_back({path,
                        {},
                        {},
                        "planner.options." + option.name,
                        "expected " +
                            std::string(option.type == OptionType::kChoice    ? "one of "
                                        : option.type == OptionType::kInteger ? "an integer in "
                                                                              : "a number in ") +
                            option.range() + ", found \"" + text + "\""});
    };
    if (option.type == OptionType::kChoice) {
      if (std::find(option.choices.begin(), option.choices.end(), text) == option.choices.end()) {
        wrong();
      }
      choices_[option.name] = text;
      continue;
    }
    const std::optional<double> value = numberIn(text);
    const bool fits = value && *value >= option.least && *value <= option.most &&
                      (option.type == OptionType::kNumber || *value == std::floor(*value));
    if (!fits) wrong();
    numbers_[option.name] = value.value_or(0);
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

double OptionValues::number(const std::string& name) const {
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) throw std::invalid_argument("no number option \"" + name + "\"");
  return found->second;
}

const std::string& OptionValues::choice(const std::string& name) const {
  const auto found = choices_.find(name);
  if (found == choices_.end()) throw std::invalid_argument("no choice option \"" + name + "\"");
  return found->second;
}

}  // namespace conceptplan
