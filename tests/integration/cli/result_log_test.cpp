#include "result_log.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const ResultKey kA{"a", "belief", 1};
const ResultKey kB{"b", "belief", 1};
const ResultKey kC{"c", "bfs", 1};

Json resultOf(const ResultKey& key) {
  return {{"scenario", key.scenario}, {"planner", key.planner}, {"seed", key.seed}};
}

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
