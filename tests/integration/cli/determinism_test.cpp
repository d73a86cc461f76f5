#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/pipeline/all_planners.hpp"
#include "domain/files/temporary_folder.hpp"
#include "integration/cli/command_runner.hpp"

namespace conceptplan::cli {
namespace {

using nlohmann::json;

const std::string kRefined = CONCEPTPLAN_SCENARIOS "/level4-0001";
const std::string kInfeasible = CONCEPTPLAN_SCENARIOS "/infeasible-0001";
const std::string kTwoTargets = CONCEPTPLAN_SCENARIOS "/two-targets/level3x2-0001";

/// The planners that need no other program.
std::vector<PlannerEntry> ownPlanners() {
  const PlannerRegistry registry = allPlanners();
  std::vector<PlannerEntry> planners = registry.entries();
  std::erase_if(planners, [](const PlannerEntry& entry) { return entry.name == "fast-downward"; });
  return planners;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end == std::string::npos ? text.size() : end + 1;
  }
  return lines;
}

/// A file without what is measured: `times_ms`, the column total_ms of CSV, the times of a report.
std::string withoutTimes(const std::filesystem::path& path) {
  const std::string text = readFile(path);
  if (path.extension() == ".html") {
    const std::size_t begin = text.find("<caption>Time</caption>");
    const std::size_t end = text.find("</table>", begin);
    EXPECT_NE(end, std::string::npos);
    return text.substr(0, begin) + text.substr(end);
  }
  if (path.extension() == ".csv" && path.filename() != "trajectory.csv") {
    return std::regex_replace(text, std::regex(",[^,\n]*\n"), "\n");
  }
  if (path.extension() == ".json" || path.extension() == ".jsonl") {
    return std::regex_replace(text, std::regex("\"times_ms\": ?\\{[^}]*\\}"), "");
  }
  return text;
}

/// At one job, at as many as there may be cores, and at more than there are.
class EachNumberOfJobs : public testing::Test {
 protected:
  /// Solves at each number of jobs and compares the results. @returns those of one job
  std::vector<json> solved(std::vector<std::string> scenarios, const std::string& planners,
                           const std::string& format = "jsonl") {
    std::string alone;
    for (const char* jobs : {"1", "2", "8"}) {
      const std::filesystem::path file = folder_ / (std::string(jobs) + "." + format);
      std::vector<std::string> arguments{"solve",  "--planners", planners,     "--jobs", jobs,
                                         "--seed", "5",          "--timeout",  "600",    "--format",
                                         format,   "--out",      file.string()};
      arguments.insert(arguments.end(), scenarios.begin(), scenarios.end());
      const CommandResult result = runCommand(arguments);
      EXPECT_LE(result.exit_code, 1) << result.error;
      const std::string text = withoutTimes(file);
      if (alone.empty()) alone = text;
      EXPECT_EQ(linesOf(text), linesOf(alone)) << "at --jobs " << jobs;
    }
    std::vector<json> results;
    if (format != "jsonl") return results;
    for (const std::string& line : linesOf(readFile(folder_ / "1.jsonl"))) {
      results.push_back(json::parse(line));
    }
    return results;
  }

  const TemporaryFolder folder_;
};

TEST_F(EachNumberOfJobs, EveryPlannerGivesTheSameResults) {
  std::vector<std::string> planners;
  for (const PlannerEntry& entry : ownPlanners()) planners.push_back(entry.name);
  ASSERT_GE(planners.size(), 11u);
  const std::vector<json> results = solved({kRefined, kInfeasible}, joined(planners));
  ASSERT_EQ(results.size(), 2 * planners.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    const json& result = results[i];
    const bool refined = i < planners.size();
    EXPECT_EQ(result["planner"], planners[i % planners.size()]);
    EXPECT_EQ(result["status"], refined ? "solved" : "infeasible") << result["planner"];
    EXPECT_EQ(result["refinement"].is_object(), refined) << result["planner"];
    EXPECT_FALSE(result["trace"]["rejections"].empty()) << result["planner"];
  }
}

TEST_F(EachNumberOfJobs, EveryPlannerOfSeveralTargetsGivesTheSameResults) {
  std::vector<std::string> planners;
  for (const PlannerEntry& entry : ownPlanners()) {
    if (entry.make_joint) planners.push_back(entry.name);
  }
  ASSERT_GE(planners.size(), 4u);
  const std::vector<json> results = solved({kTwoTargets}, joined(planners));
  ASSERT_EQ(results.size(), planners.size());
  for (const json& result : results) EXPECT_EQ(result["status"], "solved") << result["planner"];
}

TEST_F(EachNumberOfJobs, CsvIsTheSame) { solved({kRefined, kInfeasible}, "belief,astar", "csv"); }

TEST_F(EachNumberOfJobs, PlanWritesTheSameFiles) {
  std::map<std::string, std::string> alone;
  for (const char* jobs : {"1", "2", "8"}) {
    const std::filesystem::path out = folder_ / jobs;
    const CommandResult result =
        runCommand({"plan", kRefined, "--jobs", jobs, "--timeout", "600", "--out", out.string()});
    ASSERT_EQ(result.exit_code, 0) << result.error;
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(out)) {
      files[entry.path().filename().string()] = withoutTimes(entry.path());
    }
    for (const char* name :
         {"result.json", "report.html", "step-01.png", "trajectory.json", "trajectory.csv"}) {
      EXPECT_TRUE(files.contains(name)) << name;
    }
    if (alone.empty()) alone = files;
    ASSERT_EQ(files.size(), alone.size());
    for (const auto& [name, bytes] : files) {
      EXPECT_TRUE(bytes == alone[name]) << name << " differs at --jobs " << jobs;
    }
  }
}

}  // namespace
}  // namespace conceptplan::cli
