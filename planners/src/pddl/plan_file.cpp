#include "conceptplan/planners/pddl/plan_file.hpp"

#include <algorithm>
#include <charconv>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/nearest_name.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "pddl_names.hpp"

namespace conceptplan {
namespace {

constexpr std::string_view kBlank = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(kBlank), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

bool isName(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '-' ||
           letter == '_';
  });
}

/// Bytes that can be shown, at most some of them, in quotes.
std::string quoted(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string shown(text.substr(0, kMost));
  for (char& letter : shown) {
    if (letter < ' ' || letter > '~') letter = '?';
  }
  return "\"" + shown + (text.size() > kMost ? "..." : "") + "\"";
}

class PlanFileParser {
 public:
  explicit PlanFileParser(const std::filesystem::path& path) : path_(path) {}

  PlanFile parse(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      readLine(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!faults_.empty()) throw InputError(std::move(faults_));
    return std::move(plan_);
  }

 private:
  /// @param part of the line, for the column
  void fault(std::string_view part, const std::string& message) {
    const auto column = static_cast<int>(part.data() - begin_) + 1;
    faults_.push_back({path_.string(), line_, column, "", message});
  }

  void readLine(std::string_view line) {
    begin_ = line.data();
    const std::size_t comment = std::min(line.find(';'), line.size());
    const std::string_view action = trimmed(line.substr(0, comment));
    if (!action.empty()) readAction(action);
    if (comment < line.size()) readComment(line.substr(comment + 1));
  }

  void readAction(std::string_view text) {
    if (text.front() != '(' || text.back() != ')' || text.size() < 2) {
      fault(text, "expected (ACTION ARGUMENT...), found " + quoted(text));
      return;
    }
    const std::vector<std::string_view> words = wordsOf(text.substr(1, text.size() - 2));
    if (words.empty()) {
      fault(text, "expected an action within the parentheses");
      return;
    }
    PlanFileStep step;
    step.line = line_;
    const std::string given = lowerCase(words.front());
    if (const std::optional<Action> action = actionNamed(given)) {
      step.action = *action;
    } else {
      fault(words.front(),
            "unknown action " + quoted(words.front()) + didYouMean(given, actionNames()));
    }
    for (auto word = words.begin() + 1; word != words.end(); ++word) {
      step.arguments.push_back(lowerCase(*word));
      if (!isName(step.arguments.back())) fault(*word, "expected a name, found " + quoted(*word));
    }
    plan_.steps.push_back(std::move(step));
  }

  /// "cost = 20100 (general cost)" counts, all else is for people.
  void readComment(std::string_view text) {
    const std::vector<std::string_view> words = wordsOf(text);
    if (words.size() < 2 || words[0] != "cost" || words[1] != "=") return;
    const std::string_view number = words.size() > 2 ? words[2] : std::string_view();
    std::int64_t cost = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), cost);
    const bool unit = words.size() == 5 && words[3] == "(unit" && words[4] == "cost)";
    const bool general = words.size() == 5 && words[3] == "(general" && words[4] == "cost)";
    if (error != std::errc() || end != number.data() + number.size() || cost < 0 ||
        !(unit || general)) {
      fault(text, "expected \"; cost = N (unit cost)\" or \"; cost = N (general cost)\"");
    } else if (plan_.cost) {
      fault(text, "the cost is stated twice");
    } else {
      plan_.cost = cost;
      plan_.unit_cost = unit;
    }
  }

  const std::filesystem::path& path_;
  PlanFile plan_;
  std::vector<Fault> faults_;
  int line_ = 0;
  const char* begin_ = nullptr;  // of the line
};

}  // namespace

PlanFile parsePlanFile(std::string_view text, const std::filesystem::path& path) {
  return PlanFileParser(path).parse(text);
}

PlanFile readPlanFile(const std::filesystem::path& path) {
  return parsePlanFile(readFile(path), path);
}

std::string planFileText(const PlanFile& plan) {
  std::string text;
  for (const PlanFileStep& step : plan.steps) {
    text += "(" + std::string(name(step.action));
    for (const std::string& argument : step.arguments) text += " " + argument;
    text += ")\n";
  }
  if (plan.cost) {
    text += "; cost = " + std::to_string(*plan.cost) +
            (plan.unit_cost ? " (unit cost)\n" : " (general cost)\n");
  }
  return text;
}

}  // namespace conceptplan
