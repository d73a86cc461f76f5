#include "conceptplan/ompl/symbol_space_information.hpp"

#include <gmock/gmock.h>
#include <ompl/base/goals/GoalState.h>

#include <future>
#include <set>
#include <sstream>
#include <stdexcept>

#include "conceptplan/ompl/action_space.hpp"
#include "integration/ompl/task_graph.hpp"

namespace conceptplan {
namespace {

using testing::graphOf;
using testing::testTask;
using testing::tinyGraph;
using testing::tinySymbols;
using StateType = SymbolStateSpace::StateType;

ompl::control::SpaceInformationPtr tinySpace() {
  return makeSpaceInformation(tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)));
}

StateType stateOf(std::size_t id) { return StateType(static_cast<StateId>(id)); }

struct ControlOf final : ActionSpace::ControlType {
  explicit ControlOf(Action action) { value = static_cast<int>(action); }
};

TEST(SymbolSpaceInformation, IsSetUpAndItsStateSpaceIsSane) {
  const auto space = makeSpaceInformation(graphOf(testTask(4, 0)));
  EXPECT_TRUE(space->isSetup());
  EXPECT_NO_THROW(space->getStateSpace()->sanityChecks());
  EXPECT_EQ(space->getPropagationStepSize(), 1);
  EXPECT_EQ(space->getMaxControlDuration(), 1u);
  EXPECT_FALSE(space->canPropagateBackward());
}

TEST(SymbolSpaceInformation, PropagatesToTheMostProbableOutcome) {
  const auto graph = graphOf(testTask(4, 3));
  const auto space = makeSpaceInformation(graph);
  std::size_t illegal = 0;
  for (std::size_t i = 0; i < space->getStateSpace()->as<SymbolStateSpace>()->numStates(); ++i) {
    for (const Action action : kActions) {
      StateType from = stateOf(i);
      StateType to;
      ControlOf control(action);
      space->propagate(&from, &control, 1, &to);
      if (graph->legality(from.id, action) > 0.01) {
        EXPECT_EQ(to.id, graph->transitions(from.id, action).front().state);
      } else {
        ++illegal;
        EXPECT_FALSE(space->isValid(&to));
      }
    }
  }
  EXPECT_GT(illegal, 0u);
}

TEST(SymbolSpaceInformation, ADurationIsANumberOfActionsAndNoActionStays) {
  const auto space = tinySpace();
  const SymbolGraph& graph = space->getStateSpace()->as<SymbolStateSpace>()->graph();
  StateType from(graph.state(tinySymbols(0, 0, 0, 0)));
  StateType to;
  ControlOf control(Action::kMoveRight);
  space->getStatePropagator()->propagate(&from, &control, 2, &to);
  EXPECT_EQ(graph.symbols(to.id), tinySymbols(0, 2, 0, 0));
  space->nullControl(&control);
  EXPECT_EQ(ActionSpace::action(&control), std::nullopt);
  space->getStatePropagator()->propagate(&from, &control, 1, &to);
  EXPECT_EQ(to.id, from.id);
}

TEST(SymbolSpaceInformation, ValidityIsThatOfTheGraphAndThreadsShareIt) {
  const auto graph = graphOf(testTask(4, 1));
  const auto space = makeSpaceInformation(graph);
  const std::size_t states = space->getStateSpace()->as<SymbolStateSpace>()->numStates();
  const auto count = [&] {
    std::size_t valid = 0;
    for (std::size_t i = 0; i < states; ++i) {
      StateType state = stateOf(i);
      EXPECT_EQ(space->isValid(&state), graph->valid(state.id));
      valid += space->isValid(&state) ? 1 : 0;
    }
    return valid;
  };
  std::vector<std::future<std::size_t>> counts;
  for (int i = 0; i < 4; ++i) counts.push_back(std::async(std::launch::async, count));
  for (auto& valid : counts) EXPECT_LT(valid.get(), states);
}

TEST(SymbolSpaceInformation, TheStartCountsAsValidWhereverItStands) {
  Task task = testTask(4, 1);
  task.initial.objects[task.initial.target].cell =
      task.initial.objects[task.initial.target == 0 ? 1 : 0].cell;
  const auto graph = graphOf(task);
  ASSERT_FALSE(graph->valid(graph->mostProbableStart()));
  StateType start(graph->mostProbableStart());
  EXPECT_TRUE(makeSpaceInformation(graph)->isValid(&start));
}

TEST(SymbolSpaceInformation, TwoStatesAreJoinedWhereAnActionLeadsFromOneToTheOther) {
  const auto graph = graphOf(testTask(2, 0));
  const auto space = makeSpaceInformation(graph);
  const auto* states = space->getStateSpace()->as<SymbolStateSpace>();
  std::size_t joined = 0;
  for (std::size_t i = 0; i < states->numStates(); ++i) {
    for (std::size_t k = 0; k < states->numStates(); ++k) {
      StateType from = stateOf(i);
      StateType to = stateOf(k);
      bool expected = i == k;
      for (const Action action : kActions) {
        expected = expected || (graph->legality(from.id, action) > 0.01 &&
                                graph->transitions(from.id, action).front().state == to.id);
      }
      expected = expected && graph->valid(from.id) && graph->valid(to.id);
      EXPECT_EQ(space->checkMotion(&from, &to), expected);
      joined += expected ? 1 : 0;
    }
  }
  EXPECT_GT(joined, states->numStates());
}

TEST(SymbolSpaceInformation, AMotionThatTheCheckDeniesIsInvalidAndNoActionMakesIt) {
  const auto graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0));
  SymbolSpaceOptions options;
  options.check_motion = [](const Symbols& from, const Symbols& to) {
    EXPECT_NE(from, to);
    return index(to[index(Concept::kPositionX)]) != 2;
  };
  const auto space = makeSpaceInformation(graph, options);
  StateType left(graph->state(tinySymbols(0, 0, 0, 0)));
  StateType middle(graph->state(tinySymbols(0, 1, 0, 0)));
  StateType right(graph->state(tinySymbols(0, 2, 0, 0)));
  EXPECT_TRUE(space->checkMotion(&left, &middle));
  EXPECT_FALSE(space->checkMotion(&middle, &right));
  EXPECT_TRUE(space->checkMotion(&right, &middle));
  EXPECT_TRUE(space->checkMotion(&right, &right));
  EXPECT_TRUE(makeSpaceInformation(graph)->checkMotion(&middle, &right));

  StateType to;
  ControlOf control(Action::kMoveRight);
  space->propagate(&middle, &control, 1, &to);
  EXPECT_FALSE(space->isValid(&to));
  const auto sampler = space->allocControlSampler();
  for (int i = 0; i < 100; ++i) {
    sampler->sample(&control, &middle);
    EXPECT_NE(ActionSpace::action(&control), Action::kMoveRight);
  }
}

TEST(SymbolSpaceInformation, MotionsToAndFromInvalidStatesAreNotAskedFor) {
  Task task = testTask(4, 1);
  task.initial.objects[task.initial.target].cell =
      task.initial.objects[task.initial.target == 0 ? 1 : 0].cell;
  const auto graph = graphOf(task);
  std::size_t asked = 0;
  SymbolSpaceOptions options;
  options.check_motion = [&](const Symbols& from, const Symbols& to) {
    EXPECT_TRUE(graph->valid(graph->state(from)) && graph->valid(graph->state(to)));
    ++asked;
    return false;
  };
  const auto space = makeSpaceInformation(graph, options);
  const auto* states = space->getStateSpace()->as<SymbolStateSpace>();
  std::size_t out_of_start = 0;
  for (std::size_t i = 0; i < states->numStates(); ++i) {
    for (const Action action : kActions) {
      const StateId from = stateOf(i).id, to = states->next(from, action);
      if (from == graph->mostProbableStart() && states->contains(to)) ++out_of_start;
    }
  }
  EXPECT_GT(asked, 0u);
  EXPECT_GT(out_of_start, 0u);
}

TEST(SymbolSpaceInformation, AMotionThatFailsIsValidUpToItsStart) {
  const auto space = tinySpace();
  const SymbolGraph& graph = space->getStateSpace()->as<SymbolStateSpace>()->graph();
  StateType from(graph.state(tinySymbols(0, 0, 0, 0)));
  StateType to(graph.state(tinySymbols(0, 2, 0, 0)));
  StateType last;
  std::pair<ompl::base::State*, double> last_valid{&last, 1};
  EXPECT_FALSE(space->getMotionValidator()->checkMotion(&from, &to, last_valid));
  EXPECT_EQ(last.id, from.id);
  EXPECT_EQ(last_valid.second, 0);
}

TEST(SymbolSpaceInformation, ControlsAreDrawnFromTheActionsThatMove) {
  const auto space = tinySpace();
  const SymbolGraph& graph = space->getStateSpace()->as<SymbolStateSpace>()->graph();
  const auto sampler = space->allocControlSampler();
  StateType corner(graph.state(tinySymbols(0, 2, 0, 0)));
  ActionSpace::ControlType control;
  std::set<Action> drawn;
  for (int i = 0; i < 100; ++i) {
    sampler->sample(&control, &corner);
    drawn.insert(*ActionSpace::action(&control));
  }
  EXPECT_THAT(drawn, ::testing::UnorderedElementsAre(Action::kMoveLeft, Action::kRotateLeft));
}

TEST(SymbolSpaceInformation, PrintsActionsByName) {
  std::ostringstream out;
  ControlOf control(Action::kRotateLeft);
  tinySpace()->printControl(&control, out);
  EXPECT_EQ(out.str(), "rotate_left\n");
}

TEST(SymbolSpaceInformation, SetsTheStartAndTheGoalOfTheGraph) {
  const auto graph = graphOf(testTask(3, 0));
  const auto space = makeSpaceInformation(graph);
  ompl::base::ProblemDefinition problem(space);
  setStartAndGoal(problem);
  EXPECT_EQ(SymbolStateSpace::id(problem.getStartState(0)), graph->mostProbableStart());
  const auto* goal = problem.getGoal()->as<ompl::base::GoalState>();
  EXPECT_EQ(SymbolStateSpace::id(goal->getState()), graph->mostProbableGoal());
}

TEST(SymbolSpaceInformation, RefusesNoControlSamples) {
  SymbolSpaceOptions options;
  options.control_samples = 0;
  EXPECT_THAT(
      [&] {
        makeSpaceInformation(tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 0)), options);
      },
      ::testing::ThrowsMessage<std::invalid_argument>(
          ::testing::HasSubstr("control_samples is 0")));
}

}  // namespace
}  // namespace conceptplan
