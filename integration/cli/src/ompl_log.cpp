#include "ompl_log.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <thread>

namespace conceptplan::cli {
namespace {

/// Of ompl::base::PlannerStatus, in its order; version 1.5 lacks the last.
constexpr std::array kOmplStatuses{"Unknown status", "Invalid start",
                                   "Invalid goal",   "Unrecognized goal type",
                                   "Timeout",        "Approximate solution",
                                   "Exact solution", "Crash",
                                   "Abort",          "Infeasible"};

std::string omplStatus(const Json& status) {
  if (status == "solved") return "6";
  if (status == "infeasible") return "9";
  if (status == "timeout") return "4";
  if (status == "limit") return "8";
  if (status == "failed") return "7";
  if (status == "invalid_input") return "1";
  return "0";
}

/// The value at the end of a way of keys and positions; null where it leads nowhere.
Json at(const Json& document, const char* pointer) {
  const Json::json_pointer way(pointer);
  return document.contains(way) ? document[way] : Json();
}

std::string numberText(const Json& value) { return value.is_number() ? value.dump() : ""; }

std::string booleanText(const Json& value) {
  return value.is_boolean() ? (value.get<bool>() ? "1" : "0") : "";
}

std::string secondsText(const Json& milliseconds) {
  return milliseconds.is_number() ? Json(milliseconds.get<double>() / 1000).dump() : "";
}

/// A property of runs: its name, its type in SQL, and its value in a result.
struct RunProperty {
  const char* name;
  std::string (*value)(const Json& result);
};

/// By name, as in OMPL's own logs; names become columns of a table.
constexpr std::array kRunProperties{
    RunProperty{"best cost REAL", [](const Json& r) { return numberText(at(r, "/plans/0/cost")); }},
    RunProperty{"compile time REAL",
                [](const Json& r) { return secondsText(at(r, "/times_ms/compile")); }},
    RunProperty{"correct solution BOOLEAN",
                [](const Json& r) { return booleanText(at(r, "/evaluation/top1")); }},
    RunProperty{"number of plans INTEGER",
                [](const Json& r) {
                  const Json plans = at(r, "/plans");
                  return plans.is_array() ? std::to_string(plans.size()) : std::string();
                }},
    RunProperty{"perceive time REAL",
                [](const Json& r) { return secondsText(at(r, "/times_ms/perceive")); }},
    RunProperty{"probability REAL",
                [](const Json& r) { return numberText(at(r, "/plans/0/probability")); }},
    RunProperty{"refine time REAL",
                [](const Json& r) { return secondsText(at(r, "/times_ms/refine")); }},
    RunProperty{"solution length REAL",
                [](const Json& r) { return numberText(at(r, "/plans/0/length")); }},
    RunProperty{
        "solved BOOLEAN",
        [](const Json& r) { return std::string(at(r, "/status") == "solved" ? "1" : "0"); }},
    RunProperty{"states expanded INTEGER",
                [](const Json& r) { return numberText(at(r, "/statistics/expanded")); }},
    RunProperty{"states generated INTEGER",
                [](const Json& r) { return numberText(at(r, "/statistics/generated")); }},
    RunProperty{"status ENUM", [](const Json& r) { return omplStatus(at(r, "/status")); }},
    RunProperty{"time REAL", [](const Json& r) { return secondsText(at(r, "/times_ms/search")); }},
    RunProperty{"total time REAL",
                [](const Json& r) { return secondsText(at(r, "/times_ms/total")); }},
    RunProperty{"validity checks INTEGER",
                [](const Json& r) { return numberText(at(r, "/statistics/validity_checks")); }}};

/// A text on one line, without what would end it.
std::string oneLine(std::string text) {
  for (char& letter : text) {
    if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
  }
  return text;
}

/// The last word of its line is all that OMPL's script keeps of a name.
std::string oneWord(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char letter) { return letter <= ' '; }, '_');
  return text.empty() ? "unknown" : text;
}

std::string textAt(const Json& result, const char* key) {
  const Json value = at(result, key);
  return oneLine(value.is_string() ? value.get<std::string>() : "");
}

std::string timeText(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &utc);
  return text.data();
}

/// The values at a key, each once, as they come.
std::vector<std::string> distinct(const std::vector<Json>& results, const char* key) {
  std::vector<std::string> values;
  for (const Json& result : results) {
    const std::string value = textAt(result, key);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

std::string plannerText(const std::string& planner, const std::vector<Json>& results,
                        const std::vector<std::string>& scenarios) {
  std::string runs;
  std::size_t num_runs = 0;
  for (const Json& result : results) {
    if (textAt(result, "/planner") != planner) continue;
    ++num_runs;
    const auto scenario =
        std::find(scenarios.begin(), scenarios.end(), textAt(result, "/scenario"));
    runs += std::to_string(scenario - scenarios.begin() + 1) + "; ";
    for (const RunProperty& property : kRunProperties) runs += property.value(result) + "; ";
    runs += "\n";
  }
  std::string text = oneWord(planner) + "\n0 common properties\n" +
                     std::to_string(kRunProperties.size() + 1) +
                     " properties for each run\nscenario INTEGER\n";
  for (const RunProperty& property : kRunProperties) text += std::string(property.name) + "\n";
  return text + std::to_string(num_runs) + " runs\n" + runs + ".\n";
}

}  // namespace

OmplLogHeading headingHere(const std::string& experiment) {
  OmplLogHeading heading;
  heading.experiment = experiment;
  heading.start = std::chrono::system_clock::now();
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) == 0) heading.host = host.data();
  std::ifstream cpus("/proc/cpuinfo");
  for (std::string line; std::getline(cpus, line);) {
    if (!line.starts_with("model name")) continue;
    heading.cpu = std::to_string(std::thread::hardware_concurrency()) + " x" +
                  line.substr(line.find(':') + 1);
    break;
  }
  return heading;
}

std::string toOmplLog(const std::vector<Json>& results, const OmplLogHeading& heading) {
  const std::vector<std::string> scenarios = distinct(results, "/scenario");
  const std::vector<std::string> planners = distinct(results, "/planner");
  std::string text = "ConceptPlan version " CONCEPTPLAN_VERSION "\nExperiment " +
                     oneWord(heading.experiment) + "\n0 experiment properties\nRunning on " +
                     oneWord(heading.host) + "\nStarting at " + timeText(heading.start) +
                     "\n<<<|\nScenarios:\n";
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    text += std::to_string(i + 1) + ": " + scenarios[i] + "\n";
  }
  text += "|>>>\n<<<|\n" + oneLine(heading.cpu) + "\n|>>>\n" + std::to_string(heading.seed) +
          " is the random seed\n" + Json(heading.timeout_s).dump() + " seconds per run\n" +
          "0 MB per run\n" + std::to_string(scenarios.size()) + " runs per planner\n" +
          Json(heading.duration_s).dump() + " seconds spent to collect the data\n" +
          "1 enum type\nstatus";
  for (const char* status : kOmplStatuses) text += std::string("|") + status;
  text += "\n" + std::to_string(planners.size()) + " planners\n";
  for (const std::string& planner : planners) text += plannerText(planner, results, scenarios);
  return text;
}

}  // namespace conceptplan::cli
