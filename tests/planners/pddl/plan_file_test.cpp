#include "conceptplan/planners/pddl/plan_file.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/input_error.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

TEST(PlanFile, ReadsWhatPlannersWrite) {
  const PlanFile plan = parsePlanFile(
      "(move_left position_x-1 position_x-0)\n(CHANGE_COLOR Color-0 color-2)\n"
      "; cost = 20100 (general cost)\n",
      "sas_plan");
  ASSERT_EQ(plan.steps.size(), 2u);
  EXPECT_EQ(plan.steps[0].action, Action::kMoveLeft);
  EXPECT_THAT(plan.steps[0].arguments, ::testing::ElementsAre("position_x-1", "position_x-0"));
  EXPECT_EQ(plan.steps[1].action, Action::kChangeColor);
  EXPECT_THAT(plan.steps[1].arguments, ::testing::ElementsAre("color-0", "color-2"));
  EXPECT_EQ(plan.steps[1].line, 2);
  EXPECT_EQ(plan.cost, 20100);
  EXPECT_FALSE(plan.unit_cost);
}

TEST(PlanFile, SkipsEmptyLinesAndComments) {
  const PlanFile plan = parsePlanFile(
      "; a comment; cost = nothing\r\n\r\n  ( rotate_left )  ; turn\r\n\t(move_back)\r\n"
      ";cost = 2 (unit cost)",
      "plan");
  ASSERT_EQ(plan.steps.size(), 2u);
  EXPECT_EQ(plan.steps[0].line, 3);
  EXPECT_TRUE(plan.steps[0].arguments.empty());
  EXPECT_EQ(plan.cost, 2);
  EXPECT_TRUE(plan.unit_cost);
  EXPECT_TRUE(parsePlanFile("", "plan").steps.empty());
}

TEST(PlanFile, ReadingWhatWasWrittenGivesTheSamePlan) {
  const PlanFile plan{
      {{Action::kMoveFront, {"position_y-0", "position_y-1"}, 1}, {Action::kRotateRight, {}, 2}},
      7,
      false};
  EXPECT_EQ(planFileText(plan),
            "(move_front position_y-0 position_y-1)\n(rotate_right)\n; cost = 7 (general cost)\n");
  EXPECT_EQ(parsePlanFile(planFileText(plan), "plan"), plan);
  const PlanFile empty{{}, 0, true};
  EXPECT_EQ(parsePlanFile(planFileText(empty), "plan"), empty);
  EXPECT_EQ(parsePlanFile(planFileText({}), "plan"), PlanFile{});
}

TEST(PlanFile, AllFaultsComeTogetherWithLineAndColumn) {
  const std::string faults = faultsOf([] {
    parsePlanFile(
        "move_left\n"
        "(move_lefft a)\n"
        "(move_left a\n"
        "  ()\n"
        "(move_left a(b)\n"
        "; cost = many (general cost)\n"
        "; cost = 3 (general cost)\n"
        "; cost = 3 (unit cost)\n"
        "; cost = -1 (unit cost)\n"
        "; cost = 3\n"
        "(move_left) (move_left)\n",
        "dir/plan");
  });
  EXPECT_EQ(faults,
            "dir/plan:1:1: expected (ACTION ARGUMENT...), found \"move_left\"\n"
            "dir/plan:2:2: unknown action \"move_lefft\"; did you mean \"move_left\"?\n"
            "dir/plan:3:1: expected (ACTION ARGUMENT...), found \"(move_left a\"\n"
            "dir/plan:4:3: expected an action within the parentheses\n"
            "dir/plan:5:12: expected a name, found \"a(b\"\n"
            "dir/plan:6:2: expected \"; cost = N (unit cost)\" or \"; cost = N (general cost)\"\n"
            "dir/plan:8:2: the cost is stated twice\n"
            "dir/plan:9:2: expected \"; cost = N (unit cost)\" or \"; cost = N (general cost)\"\n"
            "dir/plan:10:2: expected \"; cost = N (unit cost)\" or \"; cost = N (general cost)\"\n"
            "dir/plan:11:2: unknown action \"move_left)\"; did you mean \"move_left\"?\n"
            "dir/plan:11:13: expected a name, found \"(move_left\"\n");
}

TEST(PlanFile, FilesThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(faultsOf([&] { readPlanFile(folder / "none"); }),
              ::testing::HasSubstr((folder / "none").string()));
  folder.write("plan", "(move_left)\n");
  EXPECT_EQ(readPlanFile(folder / "plan").steps.size(), 1u);
}

}  // namespace
}  // namespace conceptplan
