#include "conceptplan/planners/belief_update.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using testing::tinyModel;
using testing::tinyProblem;
using testing::tinySymbols;

/// Only column 1 is invalid.
class MiddleIsTaken final : public StateValidity {
 public:
  Verdict check(const Workbench&, const SymbolGrounding& grounding, const Symbols& target,
                std::span<const Symbols>) const override {
    if (grounding.cell(target).x == 1) return {Invalidity::kCollision, 0, 0};
    return {};
  }
  std::array<bool, kNumConcepts> dependsOn() const override {
    return {false, true, false, false, false, false};
  }
};

SymbolGraph graphWith(const StateValidity& validity) {
  return compile(tinyModel(), tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0)),
                 validity);
}

double at(const SymbolGraph& graph, const StateBelief& belief, int column, int rotation) {
  return belief[index(graph.state(tinySymbols(0, column, rotation, 0)))];
}

StateBelief mixed(const SymbolGraph& graph, double in_column_0, double in_column_2) {
  StateBelief belief(graph.numStates(), 0);
  belief[index(graph.state(tinySymbols(0, 0, 0, 0)))] = in_column_0;
  belief[index(graph.state(tinySymbols(0, 2, 0, 0)))] = in_column_2;
  return belief;
}

TEST(BeliefUpdate, Eq4SumsOverAllStatesBefore) {
  const SymbolGraph graph = graphWith(GridValidity());
  const StateBelief next = propagate(graph, mixed(graph, 0.5, 0.5), Action::kMoveRight);
  EXPECT_DOUBLE_EQ(at(graph, next, 0, 0), 0.1);
  EXPECT_DOUBLE_EQ(at(graph, next, 1, 0), 0.4);
  EXPECT_DOUBLE_EQ(at(graph, next, 2, 0), 0.5);  // not legal there, but Eq. (4) does not ask
  EXPECT_DOUBLE_EQ(std::accumulate(next.begin(), next.end(), 0.0), 1);
}

TEST(BeliefUpdate, Eq4TurnsOneConceptAndLeavesTheOthers) {
  const SymbolGraph graph = graphWith(GridValidity());
  const StateBelief next = propagate(graph, mixed(graph, 0.75, 0.25), Action::kRotateLeft);
  EXPECT_DOUBLE_EQ(at(graph, next, 0, 1), 0.75 * 0.9);
  EXPECT_DOUBLE_EQ(at(graph, next, 2, 0), 0.25 * 0.1);
}

TEST(BeliefUpdate, Eq5IgnoresIllegalActions) {
  const SymbolGraph graph = graphWith(GridValidity());
  const StateBelief next = propagateLegal(graph, mixed(graph, 0.5, 0.5), Action::kMoveRight, 0.01);
  EXPECT_DOUBLE_EQ(at(graph, next, 0, 0), 0.1);
  EXPECT_DOUBLE_EQ(at(graph, next, 1, 0), 0.4);
  EXPECT_DOUBLE_EQ(at(graph, next, 2, 0), 0);
}

TEST(BeliefUpdate, Eq5ComparesWithTheThreshold) {
  const SymbolGraph graph = graphWith(GridValidity());
  const StateBelief belief = mixed(graph, 0, 1);
  EXPECT_DOUBLE_EQ(at(graph, propagateLegal(graph, belief, Action::kMoveRight, 0.0005), 2, 0), 1);
  EXPECT_DOUBLE_EQ(at(graph, propagateLegal(graph, belief, Action::kMoveRight, 0.001), 2, 0), 0);
}

TEST(BeliefUpdate, Eq6RemovesInvalidStatesAndScales) {
  const SymbolGraph graph = graphWith(MiddleIsTaken());
  StateBelief next = propagateLegal(graph, mixed(graph, 0.5, 0.5), Action::kMoveRight, 0);
  keepValid(graph, next);
  EXPECT_DOUBLE_EQ(normalize(next), 0.6);
  EXPECT_DOUBLE_EQ(at(graph, next, 0, 0), 0.1 / 0.6);
  EXPECT_DOUBLE_EQ(at(graph, next, 1, 0), 0);
  EXPECT_DOUBLE_EQ(at(graph, next, 2, 0), 0.5 / 0.6);
}

TEST(BeliefUpdate, Eq6LeavesABeliefOfNothingAsItIs) {
  StateBelief belief(3, 0);
  EXPECT_EQ(normalize(belief), 0);
  EXPECT_THAT(belief, ::testing::Each(0));
}

TEST(BeliefUpdate, TheStartIsBelievedAmongValidStates) {
  const SymbolGraph graph = graphWith(MiddleIsTaken());
  SymbolBelief seen = certain(tinySymbols(0, 0, 0, 0), testing::kTinyCardinality);
  seen[index(Concept::kPositionX)] = {0.2, 0.6, 0.2};
  const StateBelief start = startBelief(graph, seen);
  EXPECT_DOUBLE_EQ(at(graph, start, 0, 0), 0.5);
  EXPECT_DOUBLE_EQ(at(graph, start, 1, 0), 0);
}

TEST(BeliefUpdate, AStartOfInvalidStatesAloneStays) {
  const SymbolGraph graph = graphWith(MiddleIsTaken());
  const StateBelief start =
      startBelief(graph, certain(tinySymbols(0, 1, 0, 0), testing::kTinyCardinality));
  EXPECT_DOUBLE_EQ(at(graph, start, 1, 0), 1);
}

TEST(PlanProbability, JointLosesWhatLegalityRemovesAndConditionalDoesNot) {
  const SymbolGraph graph = graphWith(GridValidity());
  const StateBelief start = mixed(graph, 0.25, 0.75);
  const StateBelief goal = mixed(graph, 0, 1);
  // Only column 2 may move left and back again.
  const PlanProbability back =
      probabilityOf(graph, {Action::kMoveLeft, Action::kMoveRight}, start, goal, 0.01);
  EXPECT_DOUBLE_EQ(back.joint, 0.75 * 0.8);
  EXPECT_DOUBLE_EQ(back.conditional, 0.8);
}

TEST(PlanProbability, OfTheEmptyPlanIsTheAgreementOfStartAndGoal) {
  const SymbolGraph graph = graphWith(GridValidity());
  const PlanProbability empty =
      probabilityOf(graph, {}, mixed(graph, 0.25, 0.75), mixed(graph, 0.5, 0.5), 0.01);
  EXPECT_DOUBLE_EQ(empty.joint, 0.5);
  EXPECT_DOUBLE_EQ(empty.conditional, 0.5);
}

}  // namespace
}  // namespace conceptplan
