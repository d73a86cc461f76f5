// Tells why there is no plan. The argument is a symbolic model.
#include <algorithm>
#include <conceptplan/planners/belief_planner.hpp>
#include <conceptplan/planners/graph_source.hpp>
#include <iostream>

using namespace conceptplan;

void explain(const PlanResult& result) {
  std::cout << name(result.status) << ": " << explanation(result) << '\n';
  for (const Rejection& step : result.rejections) {
    std::cout << "  " << name(step.action) << ": ";
    if (step.cause == Invalidity::kNone) std::cout << "Pr[action | symbols] is " << step.value;
    if (step.cause != Invalidity::kNone) std::cout << name(step.cause);
    if (step.object) std::cout << " with object " << *step.object;
    std::cout << '\n';
  }
}

int main(int argc, char** argv) try {
  const SymbolicModel model = readSymbolicModel(argc == 2 ? argv[1] : "");
  // Which symbol stands for a column or row is a matter of the model.
  const auto symbol = [](const std::vector<int>& values, int value) {
    return SymbolId(std::ranges::find(values, value) - values.begin());
  };
  const auto at = [&](int x, int y) {
    const SymbolGrounding& grounding = model.grounding;
    const Symbols symbols{SymbolId{0}, symbol(grounding.columns, x), symbol(grounding.rows, y)};
    return certain(symbols, model.cardinality());
  };
  // Object 0 at (0, 0) shall go to (0, 2); the others shut it in.
  const SymbolicProblem problem{{{}, {at(0, 0), at(0, 1), at(1, 0)}, 0}, at(0, 2)};
  // Compiled again without some objects, it tells which of them block the way.
  const GridValidity validity;
  const GraphSource source{model, validity};
  explain(BeliefPlanner().solve(compile(model, problem, validity), {.source = &source}));
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
