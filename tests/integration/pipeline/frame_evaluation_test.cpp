#include "conceptplan/pipeline/frame_evaluation.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/pipeline/generation.hpp"
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
    EXPECT_GT(row.psnr_db, 25);
    EXPECT_GT(row.ssim, 0.9);
    EXPECT_LT(row.ssim, 1);
    EXPECT_GE(row.read_back, 50);
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

TEST(EvaluateFrames, RefusesASetWithoutThePicturesOfAllSteps) {
  const TemporaryFolder folder;
  const TaskDataset tasks = smallSet(folder.path() / "tasks", Frames::kEnds);
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  EXPECT_THAT([&] { evaluateFrames(tasks, model, {}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("all steps")));
}

}  // namespace
}  // namespace conceptplan
