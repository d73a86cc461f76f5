#include "conceptplan/ompl/symbol_state_space.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "integration/ompl/task_graph.hpp"

namespace conceptplan {
namespace {

using testing::graphOf;
using testing::testTask;
using testing::tinyGraph;
using testing::tinySymbols;
using StateType = SymbolStateSpace::StateType;

StateType stateOf(std::size_t id) { return StateType(static_cast<StateId>(id)); }

std::unique_ptr<SymbolStateSpace> tinySpace() {
  return std::make_unique<SymbolStateSpace>(
      tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)));
}

TEST(SymbolStateSpace, PassesTheSanityChecksOfOmplOnEveryLevel) {
  for (int level = 1; level <= 4; ++level) {
    SymbolStateSpace space(graphOf(testTask(level, 0)));
    space.setup();
    EXPECT_NO_THROW(space.sanityChecks()) << "level " << level;
  }
  const auto tiny = tinySpace();
  tiny->setup();
  EXPECT_NO_THROW(tiny->sanityChecks());
}

TEST(SymbolStateSpace, IsDiscreteAndHoldsTheStatesOfTheMostProbableReading) {
  const auto space = tinySpace();
  EXPECT_TRUE(space->isDiscrete());
  EXPECT_FALSE(space->isCompound());
  EXPECT_EQ(space->numStates(), 6u);  // three columns, two rotations
  EXPECT_EQ(space->getDimension(), 2u);
  EXPECT_EQ(space->getMeasure(), 6);
}

TEST(SymbolStateSpace, DistanceCountsTheStepsOfEachConcept) {
  const auto space = tinySpace();
  const auto distance = [&](const Symbols& from, const Symbols& to) {
    const StateType first(space->graph().state(from));
    const StateType second(space->graph().state(to));
    return space->distance(&first, &second);
  };
  EXPECT_EQ(distance(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0)), 2);
  EXPECT_EQ(distance(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)), 3);
  EXPECT_EQ(distance(tinySymbols(0, 1, 1, 0), tinySymbols(0, 1, 1, 0)), 0);
  EXPECT_EQ(space->getMaximumExtent(), 3);
}

TEST(SymbolStateSpace, DistanceIsAMetricOnALearnedWorld) {
  const SymbolStateSpace space(graphOf(testTask(4, 1)));
  for (std::size_t a = 0; a < space.numStates(); a += 7) {
    for (std::size_t b = 0; b < space.numStates(); b += 5) {
      StateType first = stateOf(a);
      StateType second = stateOf(b);
      const double direct = space.distance(&first, &second);
      EXPECT_EQ(direct == 0, a == b);
      EXPECT_EQ(direct, space.distance(&second, &first));
      EXPECT_LE(direct, space.getMaximumExtent());
      for (std::size_t c = 0; c < space.numStates(); c += 11) {
        StateType by = stateOf(c);
        EXPECT_LE(direct, space.distance(&first, &by) + space.distance(&by, &second));
      }
    }
  }
}

TEST(SymbolStateSpace, NoActionLeadsFartherThanItsDistanceOnALearnedWorld) {
  const SymbolStateSpace space(graphOf(testTask(3, 1)));
  for (std::size_t i = 0; i < space.numStates(); ++i) {
    for (const Action action : kActions) {
      StateType from = stateOf(i);
      StateType to(space.next(from.id, action));
      if (!space.contains(to.id)) continue;
      EXPECT_LE(space.distance(&from, &to), 1);
    }
  }
}

TEST(SymbolStateSpace, AnIllegalActionLeadsNowhere) {
  const auto space = tinySpace();
  const StateId right_end = space->graph().state(tinySymbols(0, 2, 0, 0));
  StateType nowhere(space->next(right_end, Action::kMoveRight));
  EXPECT_EQ(nowhere.id, SymbolStateSpace::kNowhere);
  EXPECT_FALSE(space->satisfiesBounds(&nowhere));
  EXPECT_EQ(space->next(nowhere.id, Action::kMoveLeft), SymbolStateSpace::kNowhere);
  StateType start = stateOf(0);
  EXPECT_EQ(space->distance(&start, &nowhere), space->getMaximumExtent());
  space->enforceBounds(&nowhere);
  EXPECT_TRUE(space->satisfiesBounds(&nowhere));
}

TEST(SymbolStateSpace, InterpolationSnapsToTheNearerEnd) {
  const auto space = tinySpace();
  StateType from = stateOf(1);
  StateType to = stateOf(4);
  StateType between;
  for (const auto& [t, expected] : std::map<double, int>{{0, 1}, {0.4, 1}, {0.6, 4}, {1, 4}}) {
    space->interpolate(&from, &to, t, &between);
    EXPECT_EQ(between.id, StateId{expected}) << t;
  }
}

TEST(SymbolStateSpace, SamplesCoverAllStatesAndNearOnesStayNear) {
  const auto space = tinySpace();
  const ompl::base::StateSamplerPtr sampler = space->allocStateSampler();
  std::set<StateId> uniform;
  std::set<StateId> near;
  const StateType centre(space->graph().state(tinySymbols(0, 1, 0, 0)));
  StateType sample;
  for (int i = 0; i < 500; ++i) {
    sampler->sampleUniform(&sample);
    uniform.insert(sample.id);
    sampler->sampleUniformNear(&sample, &centre, 1);
    EXPECT_LE(space->distance(&centre, &sample), 1);
    near.insert(sample.id);
    sampler->sampleGaussian(&sample, &centre, 2);
    EXPECT_TRUE(space->satisfiesBounds(&sample));
  }
  EXPECT_EQ(uniform.size(), 6u);
  EXPECT_EQ(near.size(), 4u);
}

TEST(SymbolStateSpace, SeededSamplersRepeat) {
  const auto space = tinySpace();
  const auto draw = [&](std::uint64_t seed) {
    space->seedSamplers(seed);
    std::vector<StateId> drawn;
    for (int k = 0; k < 3; ++k) {
      const ompl::base::StateSamplerPtr sampler = space->allocStateSampler();
      for (int i = 0; i < 20; ++i) {
        StateType sample;
        sampler->sampleUniform(&sample);
        drawn.push_back(sample.id);
      }
    }
    return drawn;
  };
  EXPECT_EQ(draw(3), draw(3));
  EXPECT_NE(draw(3), draw(4));
}

TEST(SymbolStateSpace, EveryStateHasACellOfItsOwnWithinTheProjection) {
  SymbolStateSpace space(graphOf(testTask(4, 2)));
  space.setup();
  const ompl::base::ProjectionEvaluatorPtr projection = space.getDefaultProjection();
  std::set<std::vector<int>> cells;
  for (std::size_t i = 0; i < space.numStates(); ++i) {
    StateType state = stateOf(i);
    Eigen::VectorXi cell(projection->getDimension());
    projection->computeCoordinates(&state, cell);
    cells.insert({cell.data(), cell.data() + cell.size()});
    Eigen::VectorXd point(projection->getDimension());
    projection->project(&state, point);
    for (unsigned int k = 0; k < projection->getDimension(); ++k) {
      EXPECT_GT(point[k], projection->getBounds().low[k]);
      EXPECT_LT(point[k], projection->getBounds().high[k]);
    }
  }
  EXPECT_EQ(cells.size(), space.numStates());
}

TEST(SymbolStateSpace, PlacesFollowTheStepsWhateverTheSymbolsAreCalled) {
  const SymbolStateSpace space(graphOf(testTask(1, 0)));
  const Concept row = Concept::kPositionY;
  for (std::size_t place = 0; place + 1 < space.numSymbols(row); ++place) {
    EXPECT_EQ(space.steps(row, space.symbolAt(row, place), space.symbolAt(row, place + 1)), 1);
  }
  EXPECT_EQ(space.steps(row, space.symbolAt(row, 0), space.symbolAt(row, 4)), 4);
}

TEST(SymbolStateSpace, PrintsTheSymbolsOfAState) {
  const auto space = tinySpace();
  const StateType state(space->graph().state(tinySymbols(0, 2, 1, 0)));
  std::ostringstream out;
  space->printState(&state, out);
  EXPECT_THAT(out.str(), ::testing::HasSubstr("POSITION_X 2 ROTATION 1"));
}

TEST(SymbolStateSpace, RefusesNoGraphAndAThresholdOutOfRange) {
  using ::testing::HasSubstr;
  using ::testing::ThrowsMessage;
  EXPECT_THAT([] { SymbolStateSpace space(nullptr); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("needs a symbol graph")));
  const auto graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 0));
  EXPECT_THAT([&] { SymbolStateSpace space(graph, 2); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("legality_threshold is 2")));
}

}  // namespace
}  // namespace conceptplan
