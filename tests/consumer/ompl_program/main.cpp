// A program of OMPL that plans in symbols: a planner of OMPL first, then one of ours in its place.
#include <ompl/control/SimpleSetup.h>
#include <ompl/control/planners/rrt/RRT.h>

#include <conceptplan/ompl/action_space.hpp>
#include <conceptplan/ompl/graph_planner.hpp>
#include <conceptplan/ompl/symbol_space_information.hpp>
#include <conceptplan/planners/belief_planner.hpp>
#include <iostream>

using namespace conceptplan;

// One action moves a symbol of an axis by one; at its end it stays.
void move(EffectTable& effects, Action action, Concept axis, int by) {
  Effect& effect = effects[index(action)][index(axis)];
  effect.context = {{ContextKind::kOwnSymbol, axis}};
  const int count = static_cast<int>(kConceptCardinality[index(axis)]);
  for (int from = 0; from < count; ++from) {
    if (from + by < 0 || from + by >= count) continue;
    effect.rows[from].assign(count, 0.0);
    effect.rows[from][from + by] = 1;
  }
}

SymbolBelief bread(int column, int row) {
  return certain({SymbolId{0}, SymbolId{column}, SymbolId{row}}, kConceptCardinality);
}

int main() {
  EffectTable effects;
  move(effects, Action::kMoveFront, Concept::kPositionY, 1);
  move(effects, Action::kMoveBack, Concept::kPositionY, -1);
  move(effects, Action::kMoveRight, Concept::kPositionX, 1);
  move(effects, Action::kMoveLeft, Concept::kPositionX, -1);
  const SymbolicModel model{
      standardGrounding(), {kConceptCardinality, effects}, {kConceptCardinality, {}}, {}};

  // One loaf at (0, 0) that shall go to (0, 2), and another in its way.
  const SymbolicProblem problem{{{}, {bread(0, 0), bread(0, 1)}, 0}, bread(0, 2)};
  const auto graph = std::make_shared<SymbolGraph>(compile(model, problem, GridValidity()));

  ompl::control::SimpleSetup setup(makeSpaceInformation(graph));
  setStartAndGoal(*setup.getProblemDefinition());
  const auto& space = setup.getSpaceInformation();
  setup.setPlanner(std::make_shared<ompl::control::RRT>(space));
  if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;
  std::cout << "RRT: " << setup.getSolutionPath().getControlCount() << " actions\n";

  setup.clear();
  setup.setPlanner(
      std::make_shared<GraphPlanner>(space, std::make_shared<BeliefPlanner>(), "belief"));
  if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;
  std::cout << "belief:";
  for (const auto* control : setup.getSolutionPath().getControls()) {
    std::cout << ' ' << name(*ActionSpace::action(control));
  }
  std::cout << '\n';
}
