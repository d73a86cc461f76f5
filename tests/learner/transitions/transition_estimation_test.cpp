#include "conceptplan/learner/transitions/transition_estimation.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "conceptplan/domain/simulation/simulator.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using testing::Relabelling;
using ::testing::ThrowsMessage;
using testing::trainingTriplets;

constexpr double kThreshold = 0.01;

SymbolicModel learned(const Relabelling& labels, int tasks, double misread) {
  return estimateSymbolicModel(trainingTriplets(labels, {1, 2, 3, 4}, tasks, misread, 5),
                               labels.grounding(), kConceptCardinality);
}

/// Holds the model to the simulator: in every cell with a dyer in the middle, each action that is
/// legal in truth must be legal and have its true effect, and each that is not must be illegal.
/// @param with_moves also moves into the dyer's cell, which state validity rules out anyway.
void expectTrueRules(const SymbolicModel& model, const Relabelling& labels, bool with_moves) {
  World world;
  world.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0}, {ObjectType::kDyer, {1, 2}, 0, 3, 1}};
  const std::vector<Symbols> others{labels.symbols(world.objects[1])};
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 5; ++y) {
      if (Cell{x, y} == world.objects[1].cell) continue;
      for (int rotation = 0; rotation < 4; ++rotation) {
        world.objects[0].cell = {x, y};
        world.objects[0].rotation = rotation;
        const Surroundings here{model.grounding, labels.symbols(world.objects[0]), others};
        for (const Action action : kActions) {
          const ActionOutcome truth = applyAction(world, action);
          const bool legal = model.transitions.isDefined(action, here) &&
                             model.legality.probability(action, here) > kThreshold;
          const bool known = with_moves || truth.obstruction != Obstruction::kCollision;
          const auto place = [&] {
            return std::string(name(action)) + " at " + std::to_string(x) + ", " +
                   std::to_string(y);
          };
          if (known) {
            EXPECT_EQ(legal, truth.succeeded()) << place();
          }
          if (!truth.succeeded()) continue;
          const Symbols after = labels.symbols(truth.world.objects[0]);
          for (const Concept which : kConcepts) {
            EXPECT_GT(
                model.transitions.distribution(action, which, here)[index(after[index(which)])],
                0.99)
                << place() << ", " << name(which);
          }
        }
      }
    }
  }
}

TEST(TransitionEstimation, LearnsTheRulesFromTrueSymbols) {
  const Relabelling labels(1);
  expectTrueRules(learned(labels, 1000, 0), labels, true);
}

TEST(TransitionEstimation, LearnsTheRulesFromFewTasks) {
  const Relabelling labels(2);
  expectTrueRules(learned(labels, 240, 0), labels, false);
}

TEST(TransitionEstimation, LearnsTheRulesWithThreePercentOfTheSymbolsMisread) {
  const Relabelling labels(3);
  expectTrueRules(learned(labels, 1000, 0.03), labels, false);
}

TEST(TransitionEstimation, DoesNotDependOnTheNumbersOfTheSymbols) {
  for (const std::uint64_t seed : {0, 11}) {
    const Relabelling labels(seed);
    const SymbolicModel model = learned(labels, 300, 0);
    const Effect& effect = model.transitions.effect(Action::kChangeColor, Concept::kColor);
    const ContextFeature dyers_colour{ContextKind::kNearestSymbol, Concept::kColor,
                                      labels.symbol(Concept::kType, 7)};
    EXPECT_EQ(effect.context, std::vector{dyers_colour});
  }
}

TEST(TransitionEstimation, AnEffectThatIsNoneNeedsNoContext) {
  const SymbolicModel& model = testing::learnedModel();
  for (const Action action : kActions) {
    const Effect& effect = model.transitions.effect(action, Concept::kType);
    EXPECT_TRUE(effect.context.empty());
    EXPECT_EQ(effect.stays, 1);
  }
  EXPECT_FALSE(model.transitions.changes(Concept::kSize, 1e-3));
}

TEST(TransitionEstimation, ActionsAreLegalInContextsThatWereNeverSeen) {
  const Relabelling labels(4);
  // Level 1 has no dyer and no turn, and change_color never happens.
  const SymbolicModel model = estimateSymbolicModel(trainingTriplets(labels, {1}, 400, 0, 5),
                                                    labels.grounding(), kConceptCardinality);
  const Surroundings alone{model.grounding, labels.symbols({}), {}};
  EXPECT_GT(model.legality.probability(Action::kRotateLeft, alone), kThreshold);
  EXPECT_EQ(model.transitions.distribution(Action::kRotateLeft, Concept::kRotation,
                                           alone)[index(alone.target[3])],
            1);
}

TEST(TransitionEstimation, TheAbsenceOfAnObjectForbidsNothing) {
  // Tasks without a dyer never turn the target; nothing says that they could not.
  const Relabelling& labels = testing::learnedRelabelling();
  const SymbolicModel& model = testing::learnedModel();
  const Surroundings alone{model.grounding, labels.symbols({}), {}};
  EXPECT_GT(model.legality.probability(Action::kRotateLeft, alone), kThreshold);
  EXPECT_GT(model.legality.probability(Action::kRotateRight, alone), kThreshold);
  EXPECT_FALSE(model.transitions.isDefined(Action::kChangeColor, alone));
}

TEST(TransitionEstimation, KeepsRareOutcomesThatAreTooFrequentForMisreading) {
  const Relabelling labels(0);
  std::vector<Triplet> triplets;
  for (int i = 0; i < 1000; ++i) {
    Triplet triplet{{labels.symbols({})}, 0, Action::kMoveRight, labels.symbols({})};
    triplet.after[index(Concept::kPositionX)] = SymbolId{i % 10 < 3 ? 0 : 1};
    triplet.objects[0][index(Concept::kColor)] = SymbolId{i % 6};
    triplet.after[index(Concept::kColor)] = SymbolId{i % 6};
    triplets.push_back(triplet);
  }
  const SymbolicModel model =
      estimateSymbolicModel(triplets, labels.grounding(), kConceptCardinality);
  const Surroundings alone{model.grounding, labels.symbols({}), {}};
  const std::vector<double> next =
      model.transitions.distribution(Action::kMoveRight, Concept::kPositionX, alone);
  EXPECT_NEAR(next[0], 0.3, 0.01);
  EXPECT_NEAR(next[1], 0.7, 0.2);
}

TEST(TransitionEstimation, KeepsTheCountsBesideTheProbabilities) {
  const SymbolicModel& model = testing::learnedModel();
  const std::vector<Triplet> triplets =
      trainingTriplets(testing::learnedRelabelling(), {1, 2, 3, 4}, 500, 0, 1);
  double steps = 0;
  for (const double count : model.evidence.steps) steps += count;
  EXPECT_EQ(steps, static_cast<double>(triplets.size()));
  for (const Action action : kActions) {
    double counted = 0;
    for (const auto& [value, row] :
         model.evidence.transitions[index(action)][index(Concept::kPositionX)].rows) {
      for (const double count : row) counted += count;
    }
    EXPECT_EQ(counted, model.evidence.steps[index(action)]);
  }
}

TEST(TransitionEstimation, TheSameTripletsGiveTheSameFile) {
  const Relabelling labels(6);
  EXPECT_EQ(toJson(learned(labels, 100, 0.02)), toJson(learned(labels, 100, 0.02)));
}

TEST(TransitionEstimation, TheModelSurvivesItsFile) {
  EXPECT_EQ(parseSymbolicModel(toJson(testing::learnedModel()), "x"), testing::learnedModel());
}

TEST(TransitionEstimation, RefusesTripletsThatDoNotFit) {
  const Relabelling labels(0);
  const auto estimate = [&](const std::vector<Triplet>& triplets,
                            const TransitionEstimationOptions& options = {}) {
    return [=, grounding = labels.grounding()] {
      estimateSymbolicModel(triplets, grounding, kConceptCardinality, options);
    };
  };
  const Triplet good{{labels.symbols({})}, 0, Action::kMoveRight, labels.symbols({})};
  EXPECT_THAT(estimate({}),
              ThrowsMessage<std::invalid_argument>("there are no triplets to learn from"));
  Triplet no_target = good;
  no_target.target = 1;
  EXPECT_THAT(estimate({good, no_target}),
              ThrowsMessage<std::invalid_argument>("triplet 1: the target is object 1 of 1"));
  Triplet no_symbol = good;
  no_symbol.after[index(Concept::kColor)] = SymbolId{6};
  EXPECT_THAT(estimate({no_symbol}),
              ThrowsMessage<std::invalid_argument>("triplet 0: COLOR symbol 6 is not below 6"));
  TransitionEstimationOptions options;
  options.misread_share = 0.5;
  EXPECT_THAT(estimate({good}, options),
              ThrowsMessage<std::invalid_argument>(HasSubstr("misread_share is 0.5")));
}

}  // namespace
}  // namespace conceptplan
