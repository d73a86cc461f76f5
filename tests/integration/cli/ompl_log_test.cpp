#include "ompl_log.hpp"

#include <gmock/gmock.h>

#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "result_json.hpp"

namespace conceptplan::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Reads a log by the rules of OMPL's ompl_benchmark_statistics.py: lines are split into words, of
/// which some must be there, and some, counted from either end, are the values.
class LogReader {
 public:
  explicit LogReader(const std::string& text) : lines_(text) {
    std::vector<std::string> words = line();
    expect(words.at(1) == "version", "version");
    version = words.front() + " " + words.back();
    words = line();
    expect(words.front() == "Experiment", "Experiment");
    experiment = words.back();
    for (int count = counted("experiment properties"); count > 0; --count) line();
    words = line();
    expect(words.front() == "Running", "Running");
    host = words.back();
    words = line();
    expect(words.front() == "Starting", "Starting");
    date = words.at(2) + " " + words.at(3);
    setup = multiline();
    cpu = multiline();
    seed = counted("random seed");
    timeout_s = amount("seconds per run");
    amount("MB per run");
    runs_per_planner = counted("runs per planner");
    amount("collect the data");
    for (int count = counted("enum type"); count > 0; --count) {
      std::istringstream fields(rawLine());
      std::string name, value;
      std::getline(fields, name, '|');
      while (std::getline(fields, value, '|')) enums[name].push_back(value);
    }
    for (int count = counted("planners"); count > 0; --count) readPlanner();
    expect(!std::getline(lines_, text_), "the end");
  }

  /// The values of a property in all runs of a planner.
  const std::vector<std::string>& at(const std::string& planner, const std::string& property) {
    return values.at(planner).at(property);
  }

  std::string version, experiment, host, date, setup, cpu;
  int seed = 0;
  double timeout_s = 0;
  int runs_per_planner = 0;
  std::map<std::string, std::vector<std::string>> enums;
  std::vector<std::string> planners;
  std::map<std::string, std::map<std::string, std::vector<std::string>>> values;
  std::map<std::string, std::string> types;

 private:
  static void expect(bool right, const std::string& what) {
    if (!right) throw std::runtime_error("expected " + what);
  }

  std::string rawLine() {
    expect(static_cast<bool>(std::getline(lines_, text_)), "a line");
    return text_;
  }

  std::vector<std::string> line() {
    std::istringstream text(rawLine());
    return {std::istream_iterator<std::string>(text), {}};
  }

  double amount(const std::string& last_words) {
    const std::string text = rawLine();
    expect(text.ends_with(" " + last_words), last_words + ", found " + text);
    std::size_t end = 0;
    const double value = std::stod(text, &end);
    expect(text[end] == ' ', "a number alone");
    return value;
  }

  int counted(const std::string& last_words) { return static_cast<int>(amount(last_words)); }

  std::string multiline() {
    expect(rawLine().starts_with("<<<|"), "<<<|");
    std::string text;
    while (!rawLine().starts_with("|>>>")) text += text_ + "\n";
    return text;
  }

  void readPlanner() {
    planners.push_back(rawLine());
    for (int count = counted("common properties"); count > 0; --count) rawLine();
    std::vector<std::string> columns;
    for (int count = counted("properties for each run"); count > 0; --count) {
      const std::vector<std::string> words = line();
      std::string column = words.front();
      for (std::size_t i = 1; i + 1 < words.size(); ++i) column += "_" + words[i];
      expect(column.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos,
             "a name that SQL takes without quotes, found " + column);
      types[column] = words.back();
      columns.push_back(column);
    }
    for (int count = counted("runs"); count > 0; --count) {
      std::string text = rawLine();
      for (const std::string& column : columns) {
        const std::size_t end = text.find("; ");
        expect(end != std::string::npos, "a value of " + column);
        values[planners.back()][column].push_back(text.substr(0, end));
        text.erase(0, end + 2);
      }
      expect(text.empty(), "no more values");
    }
    expect(rawLine() == ".", "a dot");
  }

  std::istringstream lines_;
  std::string text_;
};

Json result(const std::string& scenario, const std::string& planner, const std::string& status) {
  Json json = failedJson({scenario, planner, 3}, "");
  json["status"] = status;
  json["times_ms"]["search"] = 12.5;
  json["statistics"]["expanded"] = 42;
  if (status != "solved") return json;
  json["plans"] = {
      {{"actions", {"move_left"}}, {"probability", 0.9}, {"cost", 0.1}, {"length", 1}}};
  json["evaluation"] = {{"top1", true}, {"top5", true}};
  return json;
}

OmplLogHeading heading() {
  OmplLogHeading heading;
  heading.experiment = "two words";
  heading.host = "bench";
  heading.cpu = "2 x cpu\n|>>>";
  heading.seed = 3;
  heading.timeout_s = 10;
  return heading;
}

TEST(OmplLog, ReadsAsOmplsOwn) {
  LogReader log(toOmplLog({result("a", "belief", "solved"), result("a", "bfs", "infeasible"),
                           result("b", "belief", "timeout"), result("b", "bfs", "solved")},
                          heading()));
  EXPECT_THAT(log.version, HasSubstr("ConceptPlan "));
  EXPECT_EQ(log.experiment, "two_words");
  EXPECT_EQ(log.host, "bench");
  EXPECT_EQ(log.date, "1970-01-01 00:00:00");
  EXPECT_EQ(log.setup, "Scenarios:\n1: a\n2: b\n");
  EXPECT_EQ(log.seed, 3);
  EXPECT_EQ(log.timeout_s, 10);
  EXPECT_EQ(log.runs_per_planner, 2);
  EXPECT_THAT(log.planners, ElementsAre("belief", "bfs"));
  EXPECT_THAT(log.at("belief", "scenario"), ElementsAre("1", "2"));
  EXPECT_THAT(log.at("belief", "solved"), ElementsAre("1", "0"));
  EXPECT_THAT(log.at("belief", "time"), ElementsAre("0.0125", "0.0125"));
  EXPECT_THAT(log.at("belief", "solution_length"), ElementsAre("1", ""));
  EXPECT_THAT(log.at("belief", "best_cost"), ElementsAre("0.1", ""));
  EXPECT_THAT(log.at("belief", "correct_solution"), ElementsAre("1", ""));
  EXPECT_THAT(log.at("bfs", "states_expanded"), ElementsAre("42", "42"));
  const std::vector<std::string>& statuses = log.enums.at("status");
  EXPECT_EQ(statuses.at(std::stoul(log.at("belief", "status")[0])), "Exact solution");
  EXPECT_EQ(statuses.at(std::stoul(log.at("belief", "status")[1])), "Timeout");
  EXPECT_EQ(statuses.at(std::stoul(log.at("bfs", "status")[0])), "Infeasible");
  EXPECT_EQ(log.types.at("status"), "ENUM");
  EXPECT_EQ(log.types.at("solved"), "BOOLEAN");
  EXPECT_EQ(log.types.at("time"), "REAL");
}

TEST(OmplLog, NamesCannotBreakTheLog) {
  LogReader log(toOmplLog({result("a\n|>>>", "my planner\n.", "solved")}, heading()));
  EXPECT_EQ(log.setup, "Scenarios:\n1: a |>>>\n");
  EXPECT_THAT(log.planners, ElementsAre("my_planner_."));
}

TEST(OmplLog, WhatAResultLacksStaysEmpty) {
  const Json bare{{"scenario", "a"}, {"planner", "p"}, {"seed", 0}, {"plans", "none"}};
  LogReader log(toOmplLog({bare}, heading()));
  EXPECT_THAT(log.at("p", "time"), ElementsAre(""));
  EXPECT_THAT(log.at("p", "solved"), ElementsAre("0"));
  EXPECT_THAT(log.at("p", "status"), ElementsAre("0"));
}

TEST(OmplLog, TheHeadingNamesThisMachine) {
  const OmplLogHeading here = headingHere("e");
  EXPECT_NE(here.host, "");
  EXPECT_GT(here.start.time_since_epoch().count(), 0);
}

}  // namespace
}  // namespace conceptplan::cli
