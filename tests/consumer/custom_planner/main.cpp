// A planner of one's own, by name beside those of the library. The argument is a symbolic model.
#include <conceptplan/domain/input_error.hpp>
#include <conceptplan/planners/path_planning.hpp>
#include <conceptplan/planners/planner_registry.hpp>
#include <future>
#include <iostream>
#include <random>

using namespace conceptplan;

class RandomWalk final : public Planner {
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override {
    constexpr double kLegal = 0.01;
    return planByPaths(graph, query, kLegal, [&](const PathTask& task) -> std::vector<StatePath> {
      std::mt19937_64 random(query.seed);
      StatePath walk;
      StateId here = task.start;
      while (here != task.goal) {
        if (!task.guard.expand(task.statistics, here)) return {};
        if (walk.actions.size() == query.limits.horizon) {  // begin again
          walk = {};
          here = task.start;
          continue;
        }
        const Action action = kActions[random() % kNumActions];
        if (graph.legality(here, action) <= kLegal) continue;
        const Transition& outcome = graph.transitions(here, action).front();
        if (outcome.state == here || !graph.valid(outcome.state)) continue;
        here = outcome.state;
        walk.actions.push_back(action);
        walk.states.push_back(here);
        walk.cost += toPathCost(outcome.cost);
      }
      return {walk};
    });
  }
};

int main(int argc, char** argv) try {
  PlannerRegistry registry = PlannerRegistry::standard();
  registry.add({.name = "random-walk",
                .summary = "Walks at random until it comes by the goal.",
                .make = [](const OptionValues&) { return std::make_unique<RandomWalk>(); }});

  const SymbolicModel model = readSymbolicModel(argc == 2 ? argv[1] : "");
  const auto at = [&](int x, int y) {
    return certain({SymbolId{0}, SymbolId{x}, SymbolId{y}}, model.cardinality());
  };
  const SymbolicProblem problem{{{}, {at(0, 0), at(1, 1)}, 0}, at(0, 2)};
  const SymbolGraph graph = compile(model, problem, GridValidity());
  const std::unique_ptr<Planner> planner = registry.make("random-walk");
  const PlanQuery query{.top = 1, .seed = 7};
  auto other = std::async(std::launch::async, [&] { return planner->solve(graph, query); });
  const PlanResult result = planner->solve(graph, query);
  std::cout << name(result.status) << (result == other.get() ? ", twice alike\n" : "\n");
} catch (const InputError& error) {
  for (const Fault& fault : error.faults()) std::cerr << fault.text() << '\n';
  return 2;
}
