#include <gmock/gmock.h>
#include <ompl/control/SimpleSetup.h>
#include <ompl/control/planners/rrt/RRT.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"
#include "conceptplan/ompl/graph_planner.hpp"
#include "conceptplan/ompl/ompl_planner.hpp"
#include "conceptplan/ompl/symbol_space_information.hpp"
#include "integration/ompl/task_graph.hpp"

namespace conceptplan {
namespace {

using ompl::base::PlannerStatus;
using testing::learnedModel;
using testing::learnedRelabelling;
using testing::testTask;
using StateType = SymbolStateSpace::StateType;

constexpr double kPatience_s = 100;  // the machine may be busy

std::shared_ptr<const SymbolGraph> fclGraphOf(const SymbolicModel& model,
                                              const SymbolicProblem& problem) {
  return std::make_shared<SymbolGraph>(compile(model, problem, FclValidity()));
}

/// A space that asks FCL for every motion of the target among the other objects.
ompl::control::SpaceInformationPtr fclSpaceOf(std::shared_ptr<const SymbolGraph> graph,
                                              const SymbolicModel& model) {
  const SymbolicScene& scene = graph->problem().initial;
  std::vector<Symbols> others;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (i != scene.target) others.push_back(mostProbable(scene.objects[i]));
  }
  SymbolSpaceOptions options;
  options.check_motion = [validity = FclValidity(), bench = scene.workbench,
                          grounding = model.grounding,
                          others](const Symbols& from, const Symbols& to) {
    return validity.checkMotion(bench, grounding, from, to, others).valid();
  };
  return makeSpaceInformation(std::move(graph), options);
}

class OmplOnFclGraphs : public ::testing::TestWithParam<std::string> {};

TEST_P(OmplOnFclGraphs, SolvesTasksOfTheHighLevels) {
  PlannerRegistry registry;
  addOmplPlanners(registry);
  const auto planner = registry.make(GetParam());
  PlanQuery query;
  query.limits.timeout_s = kPatience_s;
  for (const int level : {3, 4}) {
    for (int i = 0; i < 5; ++i) {
      const Task task = testTask(level, i);
      const auto graph = fclGraphOf(learnedModel(), learnedRelabelling().problem(task));
      const PlanResult result = planner->solve(*graph, query);
      ASSERT_EQ(result.status, PlanStatus::kSolved) << task.id << ": " << result.reason;
      for (const Plan& plan : result.plans) {
        EXPECT_TRUE(judge(task, plan.actions).succeeded()) << task.id;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryAlgorithm, OmplOnFclGraphs,
                         ::testing::Values("ompl-rrt", "ompl-est", "ompl-kpiece", "ompl-sst",
                                           "ompl-pdst", "ompl-syclop-rrt"),
                         [](const auto& planner) {
                           std::string name = planner.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(FclMotions, LetOmplSolveTasksOfTheHighLevels) {
  for (const int level : {3, 4}) {
    const Task task = testTask(level, 1);
    const auto graph = fclGraphOf(learnedModel(), learnedRelabelling().problem(task));
    ompl::control::SimpleSetup setup(fclSpaceOf(graph, learnedModel()));
    setStartAndGoal(*setup.getProblemDefinition());
    setup.setPlanner(std::make_shared<ompl::control::RRT>(setup.getSpaceInformation()));
    EXPECT_EQ(setup.solve(kPatience_s), PlannerStatus::EXACT_SOLUTION) << task.id;
    EXPECT_TRUE(setup.getSolutionPath().check()) << task.id;
  }
}

/// An action that moves a symbol of an axis by so much, and leaves it where there is none.
void move(EffectTable& effects, Action action, Concept axis, int by) {
  Effect& effect = effects[index(action)][index(axis)];
  effect.context = {{ContextKind::kOwnSymbol, axis}};
  const int count = static_cast<int>(kConceptCardinality[index(axis)]);
  for (int from = std::max(0, -by); from < std::min(count, count - by); ++from) {
    effect.rows[from].assign(count, 0.0);
    effect.rows[from][from + by] = 1;
  }
}

/// Actions go two columns at once; beside the start stands an object, and beyond it is the goal.
class OverAnObject : public ::testing::Test {
 protected:
  static SymbolicModel twoColumnModel() {
    EffectTable effects;
    move(effects, Action::kMoveFront, Concept::kPositionY, 1);
    move(effects, Action::kMoveBack, Concept::kPositionY, -1);
    move(effects, Action::kMoveRight, Concept::kPositionX, 2);
    move(effects, Action::kMoveLeft, Concept::kPositionX, -2);
    return {standardGrounding(), {kConceptCardinality, effects}, {kConceptCardinality, {}}, {}};
  }

  static SymbolBelief at(int column, int row) {
    return certain({SymbolId{0}, SymbolId{column}, SymbolId{row}}, kConceptCardinality);
  }

  void SetUp() override { setStartAndGoal(*setup_.getProblemDefinition()); }

  PlannerStatus solveWith(const ompl::base::PlannerPtr& planner) {
    setup_.setPlanner(planner);
    return setup_.solve(kPatience_s);
  }

  const SymbolicModel model_ = twoColumnModel();
  const std::shared_ptr<const SymbolGraph> graph_ =
      fclGraphOf(model_, {{{}, {at(0, 0), at(1, 0)}, 0}, at(2, 0)});
  const ompl::control::SpaceInformationPtr space_ = fclSpaceOf(graph_, model_);
  ompl::control::SimpleSetup setup_{space_};
};

TEST_F(OverAnObject, FclDeniesAMotionWhoseEndsAreValidAndWhichAnActionJoins) {
  StateType start(graph_->mostProbableStart());
  StateType goal(graph_->mostProbableGoal());
  ASSERT_TRUE(graph_->valid(start.id) && graph_->valid(goal.id));
  EXPECT_TRUE(makeSpaceInformation(graph_)->checkMotion(&start, &goal));
  EXPECT_FALSE(space_->checkMotion(&start, &goal));
}

TEST_F(OverAnObject, OmplGoesRound) {
  EXPECT_EQ(solveWith(std::make_shared<ompl::control::RRT>(space_)), PlannerStatus::EXACT_SOLUTION);
  EXPECT_GE(setup_.getSolutionPath().getControlCount(), 3u);
  EXPECT_TRUE(setup_.getSolutionPath().check());
}

TEST_F(OverAnObject, OfOurPlansTheFirstThatGoesRoundIsTaken) {
  const auto bfs = std::shared_ptr<Planner>(PlannerRegistry::standard().make("bfs"));
  EXPECT_EQ(solveWith(std::make_shared<GraphPlanner>(space_, bfs, "first")),
            PlannerStatus::APPROXIMATE_SOLUTION);
  EXPECT_FALSE(setup_.getProblemDefinition()->hasSolutionNonExistenceProof());
  setup_.clear();
  EXPECT_EQ(solveWith(std::make_shared<GraphPlanner>(space_, bfs, "more", PlanQuery{.top = 5})),
            PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(setup_.getSolutionPath().getControlCount(), 3u);
}

}  // namespace
}  // namespace conceptplan
