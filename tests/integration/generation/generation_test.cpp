#include "conceptplan/pipeline/generation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/dataset/dataset_summary.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/rendering/renderer.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

TaskDatasetOptions smallTasks() {
  TaskDatasetOptions options;
  options.levels = {4};
  options.count = 3;
  options.frames = Frames::kEnds;
  return options;
}

std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = readFile(entry.path());
  return files;
}

TEST(GenerateTasks, AnyNumberOfJobsGivesTheSameBytes) {
  const TemporaryFolder folder;
  EXPECT_TRUE(generateTasks(folder / "one", smallTasks(), {.jobs = 1}));
  EXPECT_TRUE(generateTasks(folder / "three", smallTasks(), {.jobs = 3}));
  const auto files = contents(folder / "one");
  EXPECT_EQ(files.size(), 3u + 3 * 2 * 3);
  EXPECT_EQ(files, contents(folder / "three"));
}

TEST(GenerateTasks, FramesAreThoseOfTheRenderer) {
  const TemporaryFolder folder;
  generateTasks(folder.path(), smallTasks(), {});
  const TaskDataset dataset(folder.path());
  const Task& task = dataset.tasks()[1];
  const int last = static_cast<int>(task.reference.size());
  const RgbdImage stored = dataset.frame(task, last);
  const RgbdImage rendered =
      Renderer().render(worldAtStep(task, last), {task.appearance, RenderDomain::kStandard});
  EXPECT_EQ(stored.rgb, rendered.rgb);
  EXPECT_EQ(stored.mask, rendered.mask);
  EXPECT_EQ(stored.width, kFrameWidth);
  EXPECT_EQ(stored.height, kFrameHeight);
}

TEST(GenerateTasks, WhatIsDoneIsKeptWhenItIsCancelled) {
  const TemporaryFolder folder;
  std::atomic<bool> cancel = false;
  std::size_t done_at_cancel = 0;
  const auto cancel_after_two = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 6u);
    if (done < 2) return;
    cancel = true;
    done_at_cancel = done;
  };
  EXPECT_FALSE(generateTasks(folder.path(), smallTasks(),
                             {.jobs = 1, .progress = cancel_after_two, .cancel = &cancel}));
  EXPECT_EQ(done_at_cancel, 2u);

  std::vector<std::size_t> progress;
  EXPECT_TRUE(generateTasks(
      folder.path(), smallTasks(),
      {.progress = [&](std::size_t done, std::size_t) { progress.push_back(done); }}));
  EXPECT_THAT(progress, testing::ElementsAre(2, 3, 4, 5, 6));
  generateTasks(folder / "other", smallTasks(), {});
  auto continued = contents(folder.path());
  std::erase_if(continued, [](const auto& file) { return file.first.starts_with("other/"); });
  EXPECT_EQ(continued, contents(folder / "other"));
}

TEST(GenerateTasks, ErrorsOfThreadsReachTheCaller) {
  const TemporaryFolder folder;
  const auto fail = [](std::size_t done, std::size_t) {
    if (done > 0) throw std::runtime_error("the disk is full");
  };
  EXPECT_THAT([&] { generateTasks(folder.path(), smallTasks(), {.jobs = 2, .progress = fail}); },
              testing::ThrowsMessage<std::runtime_error>("the disk is full"));
  EXPECT_THROW(generateTasks(folder / "x", smallTasks(), {.jobs = 0}), std::invalid_argument);
}

TEST(GenerateConcepts, ShardsAreKeptAndTheSetIsThatOfTheRenderer) {
  const TemporaryFolder folder;
  const ConceptDatasetOptions options{.split = Split::kValidation, .samples = 1};
  std::atomic<bool> cancel = false;
  EXPECT_FALSE(
      generateConcepts(folder.path(), options,
                       {.jobs = 1,
                        .progress = [&](std::size_t done, std::size_t) { cancel = done > 0; },
                        .cancel = &cancel}));
  EXPECT_THAT(ConceptDatasetWriter(folder.path(), options).pendingShards(),
              testing::ElementsAre(1));
  EXPECT_TRUE(generateConcepts(folder.path(), options, {.jobs = 2}));
  EXPECT_TRUE(describeDataset(folder.path()).checksums_ok);

  const ConceptDataset dataset(folder.path());
  const ConceptSet set(0);
  Renderer renderer;
  for (const std::size_t i : {std::size_t{0}, std::size_t{500}, std::size_t{1151}}) {
    const ConceptSample sample = dataset.sample(i);
    const ObjectCrop crop = renderer.renderForeground(
        {}, sample.object, {set.appearance(combinationOf(sample.object), 0)});
    EXPECT_EQ(sample.crop.rgb, crop.rgb);
    EXPECT_EQ(sample.crop.mask, crop.mask);
    EXPECT_EQ(sample.crop.left, crop.left);
    EXPECT_EQ(sample.crop.top, crop.top);
  }
}

}  // namespace
}  // namespace conceptplan
