#include "conceptplan/domain/dataset/dataset_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/dataset/task_dataset_writer.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;

void writeTasks(const std::filesystem::path& folder, Frames frames, int count) {
  TaskDatasetOptions options;
  options.levels = {3};
  options.count = count;
  options.split = Split::kTest;
  options.frames = frames;
  const TaskDatasetWriter writer(folder, options);
  for (const auto& frame : writer.pendingFrames())
    writer.write(frame, {1, 1, {1, 2, 3}, {1.0F}, {1}});
  writer.finish();
}

TEST(DatasetSummary, CountsTasks) {
  const TemporaryFolder folder;
  writeTasks(folder.path(), Frames::kNone, 500);
  const DatasetSummary summary = describeDataset(folder.path());
  EXPECT_EQ(summary.kind, "tasks");
  EXPECT_EQ(summary.options.at("split"), "test");
  EXPECT_EQ(summary.options.at("levels"), "[3]");
  EXPECT_EQ(summary.tasks, 500u);
  EXPECT_NEAR(summary.mean_length, 4.66, 0.5);
  EXPECT_EQ(summary.length_histogram.size(), summary.max_length + 1);
  EXPECT_EQ(std::accumulate(summary.length_histogram.begin(), summary.length_histogram.end(),
                            std::size_t{0}),
            500u);
  double weighted = 0;
  for (std::size_t length = 0; length < summary.length_histogram.size(); ++length)
    weighted += static_cast<double>(length * summary.length_histogram[length]);
  EXPECT_DOUBLE_EQ(summary.mean_length, weighted / 500);
  EXPECT_EQ(summary.images, 0u);
  EXPECT_EQ(summary.objects.at("Dyer"), 500u);
  EXPECT_EQ(summary.splits.at("test"), 500u);
  EXPECT_TRUE(summary.checksums_ok);
  EXPECT_TRUE(summary.faults.empty());
}

TEST(DatasetSummary, ADamagedPictureIsAFault) {
  const TemporaryFolder folder;
  writeTasks(folder.path(), Frames::kEnds, 3);
  EXPECT_TRUE(describeDataset(folder.path()).checksums_ok);
  const std::filesystem::path mask = folder / "images" / "level3-000001" / "00.mask.png";
  std::string bytes = readFile(mask);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  writeFileAtomically(mask, bytes);
  std::filesystem::remove(folder / "images" / "level3-000002" / "00.rgb.png");
  const DatasetSummary summary = describeDataset(folder.path());
  EXPECT_EQ(summary.images, 6u);
  EXPECT_FALSE(summary.checksums_ok);
  ASSERT_EQ(summary.faults.size(), 2u);
  EXPECT_THAT(summary.faults[0].text(), HasSubstr("00.mask.png: is damaged"));
  EXPECT_THAT(summary.faults[1].text(), HasSubstr("00.rgb.png"));
}

TEST(DatasetSummary, DamagedTasksAreAFaultAndNotRead) {
  const TemporaryFolder folder;
  writeTasks(folder.path(), Frames::kNone, 2);
  folder.write("tasks.jsonl", "{\"id\": 3}\nnonsense\n");
  const DatasetSummary summary = describeDataset(folder.path());
  EXPECT_FALSE(summary.checksums_ok);
  EXPECT_EQ(summary.tasks, 0u);
  std::string texts;
  for (const Fault& fault : summary.faults) texts += fault.text() + '\n';
  EXPECT_THAT(texts, HasSubstr("tasks.jsonl:1: id: expected a text, found 3"));
  EXPECT_THAT(texts, HasSubstr("tasks.jsonl:1: goal: is missing"));
  EXPECT_THAT(texts, HasSubstr("tasks.jsonl:2: is not valid JSON"));
  EXPECT_THAT(texts, testing::Not(HasSubstr("level: expected")));
}

TEST(DatasetSummary, CountsConcepts) {
  const TemporaryFolder folder;
  const ConceptDatasetOptions options{.split = Split::kValidation, .samples = 1};
  const ConceptDatasetWriter writer(folder.path(), options);
  ObjectCrop point;
  point.rgb.assign(64 * 64 * 3, 0);
  point.depth_m.assign(64 * 64, 0);
  point.mask.assign(64 * 64, 0);
  point.depth_m[0] = 2;
  point.mask[0] = 1;
  for (const std::size_t shard : writer.pendingShards())
    writer.write(shard, std::vector<ObjectCrop>(writer.requests(shard).size(), point));
  writer.finish();
  const DatasetSummary summary = describeDataset(folder.path());
  EXPECT_EQ(summary.kind, "concepts");
  EXPECT_EQ(summary.tasks, 0u);
  EXPECT_EQ(summary.images, 1152u);
  EXPECT_EQ(summary.splits.at("validation"), 1152u);
  EXPECT_EQ(summary.objects.size(), 8u);
  EXPECT_TRUE(summary.checksums_ok);
  std::filesystem::remove(folder / "concepts-00001.bin");
  EXPECT_FALSE(describeDataset(folder.path()).checksums_ok);
}

TEST(DatasetSummary, NoDatasetIsAnInputError) {
  const TemporaryFolder folder;
  EXPECT_THAT(faultsOf([&] { describeDataset(folder.path()); }), HasSubstr("dataset.json"));
  TaskDatasetWriter(folder / "begun", {});
  EXPECT_THAT(faultsOf([&] { describeDataset(folder / "begun"); }),
              HasSubstr("the generation was interrupted"));
}

}  // namespace
}  // namespace conceptplan
