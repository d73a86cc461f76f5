#include "conceptplan/pipeline/frame_evaluation.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/pipeline/generation.hpp"
#include "domain/dataset/reseal.hpp"
#include "integration/pipeline/temporary_folder.hpp"

namespace conceptplan {
namespace {

TaskDataset smallSet(const std::filesystem::path& folder, Frames frames) {
  TaskDatasetOptions options;
  options.levels = {2, 4};
  options.count = 2;
  options.split = Split::kValidation;
  options.frames = frames;
  options.seed = 5;
  generateTasks(folder, options, {});
  return TaskDataset(folder);
}

TEST(EvaluateFrames, PredictedFramesLookAndReadAsTheyShouldAtAnyNumberOfJobs) {
  const TemporaryFolder folder;
  const TaskDataset tasks = smallSet(folder.path() / "tasks", Frames::kAll);
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  EvaluationOptions options;
  const auto rows = evaluateFrames(tasks, model, options);
  ASSERT_EQ(rows.size(), 2U);
  std::size_t steps = 0, reference = 0;
  for (const FrameEvaluationRow& row : rows) {
    EXPECT_EQ(row.set, "validation/seen/standard");
    EXPECT_GE(row.psnr_db, 29);
    EXPECT_GE(row.ssim, 0.93);
    EXPECT_LT(row.ssim, 1);
    EXPECT_GE(row.read_back, 95);
    EXPECT_LE(row.read_back, 100);
    steps += row.steps;
  }
  for (const Task& task : tasks.tasks()) reference += task.reference.size();
  EXPECT_LE(steps, reference);
  EXPECT_GT(2 * steps, reference);

  options.jobs = 2;
  const auto again = evaluateFrames(tasks, model, options);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(again[i].psnr_db, rows[i].psnr_db);
    EXPECT_EQ(again[i].ssim, rows[i].ssim);
    EXPECT_EQ(again[i].read_back, rows[i].read_back);
  }
}

TEST(EvaluateFrames, CountsTasksWithoutAPlan) {
  const TemporaryFolder folder;
  const auto root = folder.path() / "tasks";
  const Task task = smallSet(root, Frames::kAll).tasks().front();
  const auto goal = static_cast<int>(task.reference.size());
  RgbdImage empty = TaskDataset(root).frame(task, goal);
  std::ranges::fill(empty.mask, std::uint8_t{0});
  writeRgbdImage(root / "images" / task.id / ("0" + std::to_string(goal)), empty);
  resealDataset(root);
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  const auto rows = evaluateFrames(TaskDataset(root), model, {});
  EXPECT_EQ(rows[0].unplanned, 1U);
  EXPECT_GT(rows[0].planned_steps, 0U);
  EXPECT_EQ(rows[1].unplanned, 0U);
}

TEST(EvaluateFrames, RefusesASetWithoutThePicturesOfAllSteps) {
  const TemporaryFolder folder;
  const TaskDataset tasks = smallSet(folder.path() / "tasks", Frames::kEnds);
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  EXPECT_THAT([&] { evaluateFrames(tasks, model, {}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("all steps")));
  EXPECT_THAT([&] { requireAllFrames(tasks); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("all steps")));
  EXPECT_NO_THROW(requireAllFrames(smallSet(folder.path() / "all", Frames::kAll)));
}

}  // namespace
}  // namespace conceptplan
