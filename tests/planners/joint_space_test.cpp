#include "joint_space.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "planners/joint_world.hpp"

namespace conceptplan {
namespace {

using testing::drawnJointGrid;
using testing::dyerWorld;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::jointGrid;
using testing::JointWorld;

StepRules rules() {
  return {0.01, 1e-6, 1e-3,
          [](double probability) { return toPathCost(0.01 - std::log(probability)); }};
}

JointSpace spaceOf(const JointWorld& world, const StateValidity& validity) {
  SearchGuard guard(SearchLimits{});
  SearchStatistics statistics;
  return JointSpace::make(world.model, world.problem, validity, rules(), guard, statistics).value();
}

/// The start and all states that it leads to.
std::set<JointState> reachable(JointSpace& space) {
  std::set<JointState> seen{space.start()};
  std::vector<JointState> open{space.start()};
  std::vector<JointSuccessor> next;
  while (!open.empty()) {
    const JointState state = open.back();
    open.pop_back();
    space.successors(state, next);
    for (const JointSuccessor& step : next) {
      if (seen.insert(step.state).second) open.push_back(step.state);
    }
  }
  return seen;
}

/// The definition of a consistent heuristic, from which it follows that it is admissible:
/// h(goal) = 0, and h(s) <= c(s, s') + h(s') for every step.
void expectConsistentBound(const JointWorld& world) {
  const GridValidity validity;
  JointSpace space = spaceOf(world, validity);
  EXPECT_EQ(space.bound(space.goal()), 0);
  std::vector<JointSuccessor> next;
  for (const JointState state : reachable(space)) {
    space.successors(state, next);
    for (const JointSuccessor& step : next) {
      const PathRank rest = space.bound(step.state);
      EXPECT_TRUE(rest == kOutOfReach || space.bound(state) <= rankOf(step.step.cost, 1) + rest);
    }
  }
}

TEST(JointSpace, BoundIsConsistentWhereTargetsAreInEachOthersWay) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    expectConsistentBound(drawnJointGrid(3, 3, 2, 2, 2, seed));
    expectConsistentBound(testing::randomJointWorld(seed));
  }
}

TEST(JointSpace, BoundIsConsistentWhereATargetTakesTheSymbolsOfAnother) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    expectConsistentBound(dyerWorld(seed));
  }
}

TEST(JointSpace, BoundIsExactWhereTargetsDoNotMeet) {
  // Two steps for one and three for the other, on rows of their own.
  const JointWorld world = jointGrid(4, 2, 1, {{{0, 0}, {2, 0}}, {{3, 1}, {0, 1}}});
  const GridValidity validity;
  const JointSpace space = spaceOf(world, validity);
  EXPECT_EQ(space.bound(space.start()), rankOf(5 * toPathCost(0.01), 5));
}

TEST(JointSpace, NoTwoTargetsShareACell) {
  const JointWorld world = jointGrid(2, 2, 1, {{{0, 0}, {1, 1}}, {{1, 0}, {0, 1}}});
  const GridValidity validity;
  JointSpace space = spaceOf(world, validity);
  EXPECT_EQ(reachable(space).size(), 4u * 3);
  for (const JointState state : reachable(space)) {
    EXPECT_NE(space.symbols(state, 0), space.symbols(state, 1));
  }
}

TEST(JointSpace, AColourIsTakenFromWhereTheDyerHasMoved) {
  const GridValidity validity;
  std::size_t dyed = 0;
  std::vector<JointSuccessor> next;
  for (const std::uint64_t seed : {1u, 3u, 5u, 7u}) {  // worlds with one dyer
    const JointWorld world = dyerWorld(seed);
    JointSpace space = spaceOf(world, validity);
    for (const JointState state : reachable(space)) {
      const Cell thing = world.model.grounding.cell(space.symbols(state, 0));
      const Cell dyer = world.model.grounding.cell(space.symbols(state, 1));
      const bool beside = std::abs(thing.x - dyer.x) + std::abs(thing.y - dyer.y) == 1;
      const bool differs = space.symbols(state, 0)[index(Concept::kColor)] !=
                           space.symbols(state, 1)[index(Concept::kColor)];
      space.successors(state, next);
      const auto dyes = std::ranges::count_if(next, [](const JointSuccessor& step) {
        return step.target == 0 && step.step.action == Action::kChangeColor;
      });
      EXPECT_EQ(dyes, beside && differs ? 1 : 0);
      dyed += static_cast<std::size_t>(dyes);
    }
  }
  EXPECT_GT(dyed, 0u);
}

TEST(JointSpace, ChecksAPairOfPlacesOnce) {
  const JointWorld world = jointGrid(3, 2, 4, {{{0, 0, 0}, {2, 1, 2}}, {{1, 0, 0}, {1, 1, 1}}});
  const GridValidity validity;
  JointSpace space = spaceOf(world, validity);
  reachable(space);
  // Each of six cells for each target alone, and each pair of cells; rotations share them.
  EXPECT_LE(space.validityChecks(), 6u + 6 + 36);
}

TEST(JointSpace, TellsOfContradictionsWithoutASearch) {
  const GridValidity validity;
  const auto contradiction = [&](const JointWorld& world) {
    return spaceOf(world, validity).contradiction();
  };
  EXPECT_THAT(contradiction(jointGrid(3, 1, 1, {{{0, 0}, {1, 0}}, {{2, 0}, {1, 0}}})),
              HasSubstr("the goals of object 0 and object 1 rule each other out"));
  EXPECT_THAT(contradiction(jointGrid(3, 1, 1, {{{0, 0}, {2, 0}}}, {{1, 0}})),
              HasSubstr("object 0 cannot get to its goal, wherever the other targets are"));
  EXPECT_THAT(contradiction(jointGrid(3, 1, 1, {{{0, 0}, {1, 0}}, {{2, 0}, {2, 0}}})), IsEmpty());
  JointWorld dyed = dyerWorld(1);
  dyed.problem.targets.resize(1);
  dyed.problem.targets[0].name = "the cup";
  dyed.problem.objects.resize(1);
  dyed.problem.targets[0].goal[index(Concept::kColor)] =
      mostProbable(dyed.problem.objects[0])[index(Concept::kColor)] == SymbolId{0}
          ? std::vector<double>{0, 1}
          : std::vector<double>{1, 0};
  EXPECT_THAT(contradiction(dyed),
              HasSubstr("COLOR of the cup must change, and nothing here changes it"));
}

TEST(JointSpace, RefusesMoreStatesThanItCanCount) {
  std::vector<std::pair<testing::Placement, testing::Placement>> targets;
  for (std::size_t x = 0; x < 13; ++x) targets.push_back({{x, 0}, {x, 1}});
  const JointWorld world = jointGrid(13, 3, 4, targets);
  const GridValidity validity;
  EXPECT_THAT([&] { spaceOf(world, validity); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "the joint states of 13 targets cannot be counted in 63 bits"));
}

}  // namespace
}  // namespace conceptplan
