#include "result_log.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "result_json.hpp"

namespace conceptplan::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const ResultKey kA{"a", "belief", 1};
const ResultKey kB{"b", "belief", 1};
const ResultKey kC{"c", "bfs", 1};

Json resultOf(const ResultKey& key) { return failedJson(key, ""); }

std::string lineOf(const ResultKey& key) { return resultOf(key).dump() + "\n"; }

TEST(ResultLog, LinesAreThereAtOnceAndOrderedAtTheEnd) {
  const TemporaryFolder folder;
  ResultLog log(folder / "r.jsonl", {kA, kB, kC}, false);
  log.add(resultOf(kC));
  log.add(resultOf(kA));
  EXPECT_EQ(readFile(folder / "r.jsonl"), lineOf(kC) + lineOf(kA));
  log.add(resultOf(kB));
  log.finish();
  EXPECT_EQ(readFile(folder / "r.jsonl"), lineOf(kA) + lineOf(kB) + lineOf(kC));
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(ResultLog, ResumeKeepsWhatIsThereAndDropsATornLine) {
  const TemporaryFolder folder;
  folder.write("r.jsonl", lineOf(kB) + lineOf(kA).substr(0, 9));
  ResultLog log(folder / "r.jsonl", {kA, kB, kC}, true);
  EXPECT_TRUE(log.has(kB));
  EXPECT_FALSE(log.has(kA));
  EXPECT_EQ(log.numResults(), 1u);
  log.add(resultOf(kA));
  EXPECT_EQ(readFile(folder / "r.jsonl"), lineOf(kB) + lineOf(kA));
}

TEST(ResultLog, ResumeWithoutAFileBegins) {
  const TemporaryFolder folder;
  ResultLog log(folder / "below/r.jsonl", {kA}, true);
  EXPECT_EQ(log.numResults(), 0u);
  log.add(resultOf(kA));
  EXPECT_EQ(readFile(folder / "below/r.jsonl"), lineOf(kA));
}

TEST(ResultLog, WithoutResumeItBeginsAnew) {
  const TemporaryFolder folder;
  folder.write("r.jsonl", lineOf(kB));
  ResultLog log(folder / "r.jsonl", {kA, kB}, false);
  EXPECT_FALSE(log.has(kB));
  EXPECT_EQ(readFile(folder / "r.jsonl"), "");
}

TEST(ResultLog, ResultsOfOtherScenariosFollow) {
  const TemporaryFolder folder;
  folder.write("r.jsonl", lineOf(kC) + lineOf(kB));
  ResultLog log(folder / "r.jsonl", {kA, kB}, true);
  log.add(resultOf(kA));
  log.finish();
  EXPECT_EQ(readFile(folder / "r.jsonl"), lineOf(kA) + lineOf(kB) + lineOf(kC));
}

TEST(ResultLog, AForeignLineInTheMiddleIsNamed) {
  const TemporaryFolder folder;
  const auto path = folder.write("r.jsonl", lineOf(kA) + "hello\n" + lineOf(kB));
  EXPECT_THAT(faultsOf([&] { ResultLog(path, {kA}, true); }),
              HasSubstr("r.jsonl:2: expected a result of solve"));
}

TEST(ResultLog, FieldsThatNoResultHasAreNamed) {
  struct Wrong {
    const char* pointer;
    Json value;
    const char* message;
  };
  const Json plan{{"actions", {"move_left"}}, {"probability", 1}, {"cost", 0}, {"length", 1}};
  std::vector<Json> wrong_plans(4, Json::array({plan}));
  wrong_plans[0][0]["actions"] = {1};
  wrong_plans[1][0]["objects"] = {1, 2};
  wrong_plans[2][0].erase("probability");
  wrong_plans[3][0] = "move_left";
  std::vector<Wrong> all{
      {"/status", 3, "status: expected text, found number"},
      {"/times_ms", {{"search", 1}}, "times_ms: expected times with a total, found object"},
      {"/plans", "none", "plans: expected a list of plans, found string"},
      {"/evaluation",
       {{"top1", false}, {"failure", nullptr}},
       "evaluation: expected an evaluation or null, found object"}};
  for (const Json& plans : wrong_plans) {
    all.push_back({"/plans", plans, "plans: expected a list of plans, found array"});
  }
  const TemporaryFolder folder;
  for (const Wrong& wrong : all) {
    Json result = resultOf(kB);
    result[Json::json_pointer(wrong.pointer)] = wrong.value;
    const auto path = folder.write("r.jsonl", lineOf(kA) + result.dump() + "\n");
    const std::string fault = "r.jsonl:2: " + std::string(wrong.message) + "; remove the line\n";
    EXPECT_THAT(faultsOf([&] { ResultLog(path, {kA, kB}, true); }), HasSubstr(fault));
    EXPECT_THAT(faultsOf([&] { readResults(path); }), HasSubstr(fault));
  }
  Json lacking = resultOf(kB);
  lacking.erase("evaluation");
  const auto path = folder.write("r.jsonl", lacking.dump() + "\n");
  EXPECT_THAT(faultsOf([&] { readResults(path); }),
              HasSubstr("r.jsonl:1: evaluation: expected an evaluation or null, found nothing"));
}

TEST(ResultLog, WhatSolveWritesIsRead) {
  Json several = resultOf(kA);
  several["plans"] = {{{"actions", {"move_left", "move_right"}},
                       {"probability", 0.5},
                       {"cost", 1.5},
                       {"length", 2},
                       {"objects", {3, 1}}}};
  several["evaluation"] = {{"top1", false}, {"failure", "collision"}};
  const TemporaryFolder folder;
  const auto path = folder.write("r.jsonl", several.dump() + "\n" + lineOf(kB));
  EXPECT_THAT(readResults(path), ElementsAre(several, resultOf(kB)));
}

TEST(ResultLog, WithoutAFileResultsStayInMemory) {
  ResultLog log({}, {kA, kB}, false);
  log.add(resultOf(kB));
  log.add(resultOf(kA));
  log.finish();
  EXPECT_THAT(log.results(), ElementsAre(resultOf(kA), resultOf(kB)));
}

TEST(ResultLog, ResultsWithoutAKeyAreABrokenPrecondition) {
  ResultLog log({}, {kA}, false);
  EXPECT_THROW(log.add({{"scenario", "a"}}), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan::cli
