// Infeasible is said only of what is proved: a planner that gave up, or that had to leave something
// out, says that it gave up.
#include <gmock/gmock.h>

#include "conceptplan/planners/belief_planner.hpp"
#include "conceptplan/planners/joint_planner.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "planners/grid_world.hpp"
#include "planners/joint_world.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::tinyModel;
using testing::tinyProblem;
using testing::tinySymbols;

PlanQuery within(std::size_t horizon) {
  PlanQuery query;
  query.limits.horizon = horizon;
  return query;
}

TEST(BeliefProof, SequencesTooImprobableForTheSearchAreNotRuledOut) {
  // It takes 49 sure actions, each of which costs half of the score.
  const testing::GridWorld world = testing::gridWorld(30, 20, 2, 0, 1);
  const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
  BeliefPlannerOptions options;
  options.step_discount = 0.5;
  for (const Ranking ranking : {Ranking::kJoint, Ranking::kConditional}) {
    options.ranking = ranking;
    const PlanResult result = BeliefPlanner(options).solve(graph, within(60));
    EXPECT_EQ(result.status, PlanStatus::kLimit);
    EXPECT_THAT(result.plans, IsEmpty());
    EXPECT_THAT(result.reason, HasSubstr("probability is below 1e-12"));
    EXPECT_EQ(BeliefPlanner(options).solve(graph, within(48)).status, PlanStatus::kInfeasible);
  }
}

TEST(BeliefProof, StartStatesTooImprobableForTheSearchAreNotRuledOut) {
  // The colour must change, which only the less probable reading of the other object allows.
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 1, 0, 0), tinySymbols(0, 1, 0, 1));
  problem.initial.objects.push_back(certain(tinySymbols(1, 2, 0, 1), testing::kTinyCardinality));
  problem.initial.objects[1][index(Concept::kType)] = {0.7, 0.3};
  const SymbolGraph graph = compile(tinyModel(), problem, GridValidity());
  BeliefPlannerOptions options;
  options.min_hypothesis = 0.9;
  const PlanResult result = BeliefPlanner(options).solve(graph, within(24));
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_THAT(result.reason, HasSubstr("below min_hypothesis"));
}

/// The check itself fails in column 1.
class MiddleIsUnchecked final : public StateValidity {
 public:
  Verdict check(const Workbench& workbench, const SymbolGrounding& grounding, const Symbols& target,
                std::span<const Symbols> others) const override {
    if (grounding.cell(target).x == 1) return {Invalidity::kCheckFailed, 0, 0};
    return GridValidity().check(workbench, grounding, target, others);
  }
  std::array<bool, kNumConcepts> dependsOn() const override { return GridValidity().dependsOn(); }
};

TEST(UncheckedStates, AreNoProofThatThereIsNoPlan) {
  const PlannerRegistry registry = PlannerRegistry::standard();
  const auto graph_to = [](int column, int rotation) {
    return compile(tinyModel(),
                   tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, column, rotation, 0)),
                   MiddleIsUnchecked());
  };
  for (const PlannerEntry& entry : registry.entries()) {
    SCOPED_TRACE(entry.name);
    const std::unique_ptr<Planner> planner = registry.make(entry.name);
    const PlanResult behind = planner->solve(graph_to(2, 0), within(24));
    EXPECT_EQ(behind.status, PlanStatus::kLimit);
    EXPECT_EQ(
        behind.reason,
        "no plan was found, but the validity check failed in 2 states over which one may lead");
    EXPECT_EQ(planner->solve(graph_to(1, 0), within(24)).status, PlanStatus::kLimit);
    // Too far even if column 1 can be passed.
    EXPECT_EQ(planner->solve(graph_to(2, 0), within(1)).status, PlanStatus::kInfeasible);
    EXPECT_EQ(planner->solve(graph_to(0, 1), within(24)).status, PlanStatus::kSolved);
  }
}

/// The check fails wherever the target is among other objects.
class AloneIsChecked final : public StateValidity {
 public:
  Verdict check(const Workbench&, const SymbolGrounding&, const Symbols&,
                std::span<const Symbols> others) const override {
    if (!others.empty()) return {Invalidity::kCheckFailed, 0, 0};
    return {};
  }
  std::array<bool, kNumConcepts> dependsOn() const override {
    return {false, true, true, false, false, false};
  }
};

TEST(UncheckedStates, AreNoProofForSeveralTargetsEither) {
  const auto solved = [](const testing::JointWorld& world, const StateValidity& validity) {
    return JointPlanner().solve(world.model, world.problem, validity, {});
  };
  const testing::JointWorld through = testing::jointGrid(3, 1, 1, {{{0, 0}, {2, 0}}});
  PlanResult result = solved(through, MiddleIsUnchecked());
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_THAT(result.reason, HasSubstr("1 validity checks failed"));

  const testing::JointWorld two = testing::jointGrid(3, 2, 1, {{{0, 0}, {2, 0}}, {{0, 1}, {2, 1}}});
  EXPECT_EQ(solved(two, AloneIsChecked()).status, PlanStatus::kLimit);

  // An obstacle that was checked is a proof, whatever else failed.
  const testing::JointWorld shut = testing::jointGrid(4, 1, 1, {{{0, 0}, {3, 0}}}, {{2, 0}});
  result = solved(shut, MiddleIsUnchecked());
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.reason, HasSubstr("cannot get to its goal"));
}

/// move_right leads from column 0 to 1, hardly ever to 2; from 1 to 2.
SymbolicModel skippingModel() {
  EffectTable effects;
  effects[index(Action::kMoveRight)][index(Concept::kPositionX)] = {
      {{ContextKind::kOwnSymbol, Concept::kPositionX, SymbolId{0}}},
      {{0, {0, 0.999, 0.001}}, {1, {0, 0, 1}}},
      1};
  LegalityTable legality;
  legality[index(Action::kMoveRight)] = {
      {{ContextKind::kOwnSymbol, Concept::kPositionX, SymbolId{0}}, {0.3, 0.3, 0.001}}};
  return {tinyModel().grounding, TransitionModel(testing::kTinyCardinality, effects),
          ActionLegality(testing::kTinyCardinality, legality), ModelEvidence{}};
}

TEST(PolicyProof, APolicyTooLongForTheHorizonIsGivingUpAndNoFailure) {
  const SymbolGraph graph =
      compile(skippingModel(), tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0)),
              GridValidity());
  const PlannerRegistry registry = PlannerRegistry::standard();
  for (const char* name : {"value-iteration", "lrtdp", "mcts"}) {
    SCOPED_TRACE(name);
    const PlanResult result = registry.make(name)->solve(graph, within(1));
    EXPECT_EQ(result.status, PlanStatus::kLimit);
    EXPECT_THAT(result.reason, HasSubstr("not along the outcomes on which the policy rests"));
    EXPECT_EQ(registry.make(name)->solve(graph, within(2)).status, PlanStatus::kSolved);
  }
}

}  // namespace
}  // namespace conceptplan
