// What a joint planner tells of what was ruled out, what blocks the way and what is nearest.
#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

#include "conceptplan/planners/joint_planner.hpp"
#include "planners/joint_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::jointGrid;
using testing::JointWorld;
using ::testing::Pair;
using ::testing::SizeIs;

PlanResult solved(const JointWorld& world, std::size_t max_expansions = 20'000) {
  PlanQuery query;
  query.limits.max_expansions = max_expansions;
  query.count_rejections = true;
  return JointPlanner().solve(world.model, world.problem, GridValidity(), query);
}

std::size_t columnOf(const Symbols& symbols) { return index(symbols[index(Concept::kPositionX)]); }
std::size_t rowOf(const Symbols& symbols) { return index(symbols[index(Concept::kPositionY)]); }

/// How many cells all targets are away from their goals.
std::size_t cellsAway(const JointWorld& world, const std::vector<Symbols>& targets) {
  std::size_t cells = 0;
  const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Symbols goal = mostProbable(world.problem.targets[i].goal);
    cells += apart(columnOf(targets[i]), columnOf(goal)) + apart(rowOf(targets[i]), rowOf(goal));
  }
  return cells;
}

/// Collisions counted with each object.
std::vector<std::pair<std::size_t, std::size_t>> collisions(const PlanResult& result) {
  std::vector<std::pair<std::size_t, std::size_t>> counts;
  for (const RejectionCount& count : result.ruled_out.value().counts) {
    if (count.cause == Invalidity::kCollision) counts.emplace_back(*count.object, count.steps);
  }
  return counts;
}

/// Two targets that would have to pass each other in a corridor.
JointWorld corridor() { return jointGrid(5, 1, 1, {{{1, 0}, {3, 0}}, {{3, 0}, {1, 0}}}); }

TEST(JointTrace, CountsTheStepsOfEachTargetOverAllStatesThatWereExpanded) {
  const PlanResult result = solved(corridor());
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  // Ten ways to stand in five cells in this order; in four of them each target meets the other.
  EXPECT_EQ(result.ruled_out->states, 10u);
  EXPECT_THAT(collisions(result), ElementsAre(Pair(0u, 4u), Pair(1u, 4u)));
  EXPECT_FALSE(JointPlanner()
                   .solve(corridor().model, corridor().problem, GridValidity(), PlanQuery{})
                   .ruled_out);
}

TEST(JointTrace, ListsWhatWasRuledOutBesideThePlanWithTheTargetAndWhatItMeets) {
  const JointWorld world = jointGrid(4, 1, 1, {{{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}});
  const PlanResult result = solved(world);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  const auto meets = [](std::size_t moved, std::size_t object) {
    return [=](const Rejection& rejection) {
      return rejection.moved == moved && rejection.object == object &&
             rejection.cause == Invalidity::kCollision;
    };
  };
  const auto& all = result.rejections;
  const auto first = std::find_if(all.begin(), all.end(), meets(0, 1));
  ASSERT_NE(first, all.end());
  EXPECT_EQ(first->action, Action::kMoveRight);
  EXPECT_EQ(columnOf(first->state), 0u);
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), meets(1, 0)));
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Rejection& rejection) {
    return rejection.cause == Invalidity::kNone && rejection.value <= 0.01;
  }));
}

TEST(JointTrace, TheNearestIsInReachOfBothTogether) {
  const PlanResult result = solved(corridor());
  ASSERT_THAT(result.nearest, SizeIs(2));
  EXPECT_LT(columnOf(result.nearest[0]), columnOf(result.nearest[1]));
  EXPECT_EQ(cellsAway(corridor(), result.nearest), 3u);  // 4 at the start
  EXPECT_THAT(result.blocking, IsEmpty());
}

TEST(JointTrace, WhereOneIsShutInObjectsAreToBlameAndTheOthersStillGetToTheirGoals) {
  const JointWorld world =
      jointGrid(4, 2, 1, {{{0, 0}, {3, 0}}, {{0, 1}, {1, 1}}}, {{2, 0}, {2, 1}});
  const PlanResult result = solved(world);
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.reason, HasSubstr("cannot get to its goal"));
  EXPECT_THAT(result.blocking, ElementsAre(2));
  EXPECT_THAT(explanation(result), HasSubstr("; without object 2 there would be a way"));
  ASSERT_THAT(result.nearest, SizeIs(2));
  EXPECT_EQ(columnOf(result.nearest[0]), 1u);
  EXPECT_EQ(rowOf(result.nearest[0]), 0u);
  EXPECT_EQ(columnOf(result.nearest[1]), 1u);
  EXPECT_EQ(rowOf(result.nearest[1]), 1u);
  EXPECT_THAT(result.rejections, ::testing::Not(IsEmpty()));
}

TEST(JointTrace, ObjectsInOneCellBlockTogether) {
  const JointWorld world =
      jointGrid(4, 2, 1, {{{0, 0}, {3, 0}}, {{0, 1}, {1, 1}}}, {{2, 0}, {2, 1}, {2, 0}, {2, 1}});
  EXPECT_THAT(solved(world).blocking, ElementsAre(2, 4));
  JointWorld rest = world;
  rest.problem.objects.erase(rest.problem.objects.begin() + 2);
  EXPECT_EQ(solved(rest).status, PlanStatus::kInfeasible);
}

TEST(JointTrace, NoObjectsAreToBlameWhereWithoutThemTargetsCannotPassEachOther) {
  const PlanResult result =
      solved(jointGrid(5, 1, 1, {{{0, 0}, {4, 0}}, {{4, 0}, {0, 0}}}, {{2, 0}}));
  EXPECT_THAT(result.reason, HasSubstr("cannot get to its goal"));
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_THAT(result.reason, ::testing::Not(HasSubstr("not known")));
}

/// The smallest set of objects that are no targets without which there is a plan, by trying all.
std::vector<std::size_t> blockingByTryingAll(const JointWorld& world) {
  const std::size_t targets = world.problem.targets.size();
  const std::size_t obstacles = world.problem.objects.size() - targets;
  std::vector<std::size_t> best;
  for (std::size_t removed = 1; removed < std::size_t{1} << obstacles; ++removed) {
    JointWorld rest = world;
    std::vector<std::size_t> objects;
    for (std::size_t i = obstacles; i-- > 0;) {
      if ((removed >> i & 1) == 0) continue;
      objects.insert(objects.begin(), targets + i);
      rest.problem.objects.erase(rest.problem.objects.begin() +
                                 static_cast<std::ptrdiff_t>(targets + i));
    }
    const bool is_better = best.empty() || objects.size() < best.size() ||
                           (objects.size() == best.size() && objects < best);
    if (is_better && solved(rest).status == PlanStatus::kSolved) best = objects;
  }
  return best;
}

TEST(JointTrace, BlockingIsTheSmallestSetOfAllWithoutWhichThereIsAPlan) {
  std::size_t some = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const JointWorld world = testing::drawnJointGrid(3, 3, 1, 2, 5, seed);
    const PlanResult result = solved(world);
    if (result.status != PlanStatus::kInfeasible) continue;
    if (result.reason.find("cannot get to its goal") == std::string::npos) continue;
    if (result.reason.find("rule each other out") != std::string::npos) continue;
    EXPECT_EQ(result.blocking, blockingByTryingAll(world)) << seed;
    some += result.blocking.empty() ? 0 : 1;
  }
  EXPECT_GT(some, 20u);
}

TEST(JointTrace, SaysThatALimitKeptTheBlockingObjectsUnknown) {
  const JointWorld world =
      jointGrid(4, 2, 1, {{{0, 0}, {3, 0}}, {{0, 1}, {1, 1}}}, {{2, 0}, {2, 1}});
  const PlanResult result = solved(world, 2);
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_THAT(result.reason, HasSubstr("; which objects block the way is not known: stopped at the "
                                       "limit of 2 expansions"));
  EXPECT_EQ(result.statistics.expanded, 2u);
}

TEST(JointTrace, WhereTheNearestOfEachRuleEachOtherOutTheBestOfBothIsTold) {
  const JointWorld shut =
      jointGrid(4, 2, 1, {{{0, 0}, {3, 0}}, {{0, 1}, {1, 0}}}, {{2, 0}, {2, 1}});
  EXPECT_EQ(cellsAway(shut, solved(shut).nearest), 3u);
  const JointWorld same = jointGrid(3, 1, 1, {{{0, 0}, {2, 0}}, {{1, 0}, {2, 0}}});
  const PlanResult result = solved(same);
  EXPECT_THAT(result.reason, HasSubstr("rule each other out"));
  EXPECT_EQ(cellsAway(same, result.nearest), 1u);
  EXPECT_THAT(result.blocking, IsEmpty());
}

TEST(JointTrace, SaysThatALimitKeptTheNearestUnknown) {
  const JointWorld same = jointGrid(3, 1, 1, {{{0, 0}, {2, 0}}, {{1, 0}, {2, 0}}});
  const PlanResult result = solved(same, 1);
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.nearest, IsEmpty());
  EXPECT_THAT(result.reason, HasSubstr("; how near the targets get is not known: stopped at the "
                                       "limit of 1 expansions"));
}

}  // namespace
}  // namespace conceptplan
