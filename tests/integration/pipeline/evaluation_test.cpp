#include "conceptplan/pipeline/evaluation.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/pipeline/generation.hpp"
#include "integration/pipeline/temporary_folder.hpp"

namespace conceptplan {
namespace {

TaskDataset smallSet(const std::filesystem::path& folder, ObjectSet objects = ObjectSet::kSeen) {
  TaskDatasetOptions options;
  options.levels = {1, 3};
  options.count = 4;
  options.objects = objects;
  options.split = Split::kValidation;
  options.frames = Frames::kEnds;
  options.seed = 99;
  generateTasks(folder, options, {});
  return TaskDataset(folder);
}

TEST(Evaluate, GivesARowForEachPlannerAndLevelAtAnyNumberOfJobs) {
  const TemporaryFolder folder;
  const TaskDataset tasks = smallSet(folder.path() / "tasks");
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  EvaluationOptions options;
  options.planners = {"belief", "bfs"};
  const auto rows = evaluate(tasks, model, PlannerRegistry::standard(), options);
  ASSERT_EQ(rows.size(), 4U);
  for (const EvaluationRow& row : rows) {
    EXPECT_EQ(row.tasks, 4U);
    EXPECT_EQ(row.set, "validation/seen/standard");
    std::size_t failed = 0;
    for (const auto& [cause, count] : row.failures) failed += count;
    EXPECT_NEAR(row.asacc_top1, 25.0 * static_cast<double>(4 - failed), 1e-9);
    EXPECT_GE(row.asacc_top5, row.asacc_top1);
    EXPECT_LE(row.ase, 1.0);
  }
  EXPECT_EQ(rows[0].planner, "belief");
  EXPECT_EQ(rows[1].level, 3);
  for (const EvaluationRow& row : rows) EXPECT_EQ(row.asacc_top1, 100) << row.planner << row.level;

  options.jobs = 2;
  const auto again = evaluate(tasks, model, PlannerRegistry::standard(), options);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(again[i].asacc_top1, rows[i].asacc_top1);
    EXPECT_EQ(again[i].ase, rows[i].ase);
    EXPECT_EQ(again[i].fsd, rows[i].fsd);
  }
}

/// An object that fits no cluster is told, not forced: of unseen types many, of seen ones hardly
/// any.
TEST(Evaluate, TellsHowManyObjectsFitNoSymbol) {
  const TemporaryFolder folder;
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  const auto count = [&](ObjectSet objects) {
    const TaskDataset tasks = smallSet(folder.path() / name(objects), objects);
    return evaluate(tasks, model, PlannerRegistry::standard(), {});
  };
  std::size_t objects = 0, told = 0;
  for (const EvaluationRow& row : count(ObjectSet::kSeen)) {
    EXPECT_EQ(row.unseen_types.objects, 0U);
    objects += row.seen_types.objects;
    told += row.seen_types.told;
  }
  EXPECT_GE(objects, 16U);  // level 3 has a dyer and obstacles
  EXPECT_LE(told, 1U);
  const auto rows = count(ObjectSet::kUnseen);
  EXPECT_EQ(rows[0].unseen_types.objects, 4U);  // the targets alone
  EXPECT_GE(rows[0].unseen_types.told + rows[1].unseen_types.told, 5U);
  EXPECT_GE(rows[1].seen_types.objects, 4U);  // the dyers
  EXPECT_LE(rows[1].seen_types.told, 1U);
}

TEST(Evaluate, EndsWhenCancelledAndRefusesUnknownPlanners) {
  const TemporaryFolder folder;
  const TaskDataset tasks = smallSet(folder.path() / "tasks");
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  const std::atomic<bool> cancel{true};
  EvaluationOptions options;
  options.cancel = &cancel;
  EXPECT_TRUE(evaluate(tasks, model, PlannerRegistry::standard(), options).empty());
  options.planners = {"belif"};
  EXPECT_THAT([&] { evaluate(tasks, model, PlannerRegistry::standard(), options); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("belief")));
}

}  // namespace
}  // namespace conceptplan
