// Plans from symbols: no pictures, no learning, no Torch.
#include <algorithm>
#include <conceptplan/planners/belief_planner.hpp>
#include <iostream>

using namespace conceptplan;

// A model written by hand: one action moves a symbol of an axis by one; at its end it stays.
void move(EffectTable& effects, Action action, Concept axis, int by) {
  Effect& effect = effects[index(action)][index(axis)];
  effect.context = {{ContextKind::kOwnSymbol, axis}};
  const int count = static_cast<int>(kConceptCardinality[index(axis)]);
  for (int from = std::max(0, -by); from < std::min(count, count - by); ++from) {
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

  // Object 0 at (0, 0) shall go to (0, 2); object 1 is in its way.
  const SymbolicProblem problem{{{}, {bread(0, 0), bread(0, 1)}, 0}, bread(0, 2)};
  const SymbolGraph graph = compile(model, problem, GridValidity());
  for (const Plan& plan : BeliefPlanner().solve(graph, {.top = 1}).plans) {
    std::cout << "probability " << plan.probability << ':';
    for (const Action action : plan.actions) std::cout << ' ' << name(action);
  }
}
