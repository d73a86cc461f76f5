// Plans from symbols: no pictures, no learning, no Torch.
#include <conceptplan/planners/belief_planner.hpp>
#include <iostream>

using namespace conceptplan;

// A model written by hand: one action moves a symbol of an axis by one; at its end it stays.
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

void print(const PlanResult& result) {
  for (const Plan& plan : result.plans) {
    std::cout << "probability " << plan.probability << ':';
    for (const Action action : plan.actions) std::cout << ' ' << name(action);
    std::cout << '\n';
  }
  if (result.status == PlanStatus::kSolved) return;
  std::cout << name(result.status) << ": " << result.reason << '\n';
  for (const Rejection& step : result.rejections) {
    std::cout << "  " << name(step.action) << ": ";
    if (step.cause == Invalidity::kNone) std::cout << "Pr[action | symbols] is " << step.value;
    if (step.cause != Invalidity::kNone) std::cout << name(step.cause);
    if (step.object) std::cout << " with object " << *step.object;
    std::cout << '\n';
  }
}

int main() {
  EffectTable effects;
  move(effects, Action::kMoveFront, Concept::kPositionY, 1);
  move(effects, Action::kMoveBack, Concept::kPositionY, -1);
  move(effects, Action::kMoveRight, Concept::kPositionX, 1);
  move(effects, Action::kMoveLeft, Concept::kPositionX, -1);
  const SymbolicModel model{
      standardGrounding(), {kConceptCardinality, effects}, {kConceptCardinality, {}}, {}};

  // Object 0 at (0, 0) shall go to (0, 2). Object 1 is in its way; then object 2 shuts the way out.
  SymbolicProblem problem{{{}, {bread(0, 0), bread(0, 1)}, 0}, bread(0, 2)};
  print(BeliefPlanner().solve(compile(model, problem, GridValidity()), {.top = 1}));
  problem.initial.objects.push_back(bread(1, 0));
  print(BeliefPlanner().solve(compile(model, problem, GridValidity()), {.top = 1}));
}
