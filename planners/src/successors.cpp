#include "successors.hpp"

#include <cmath>

namespace conceptplan {

StateSteps::StateSteps(const SymbolGraph& graph, double legality_threshold, const Choice& choice)
    : graph_(graph.tables()) {
  for (const GraphTables::Reading& reading : graph_.readings) {
    std::vector<ActionSteps>& of_reading = steps_.emplace_back();
    for (const Action action : kActions) {
      const CompiledAction& compiled = *reading.actions[index(action)];
      ActionSteps all{action, compiled.contexts(), {0}, {}};
      all.contexts.forEach(graph_.fixed, [&](const Symbols& symbols) {
        if (compiled.legality(symbols) > legality_threshold) {
          choice(compiled.outcomes(symbols), all.steps);
        }
        all.first.push_back(static_cast<std::uint32_t>(all.steps.size()));
      });
      if (!all.steps.empty()) of_reading.push_back(std::move(all));
    }
  }
}

void StateSteps::operator()(StateId state, std::vector<Successor>& next) const {
  next.clear();
  const Symbols symbols = graph_.symbols(state);
  for (const ActionSteps& all : steps_[graph_.readingOf(state)]) {
    const std::size_t context = all.contexts(symbols);
    for (std::uint32_t i = all.first[context]; i < all.first[context + 1]; ++i) {
      const Step& step = all.steps[i];
      const auto to = static_cast<StateId>(static_cast<std::int32_t>(state) + step.shift);
      if (graph_.valid[index(to)]) next.push_back({all.action, to, step.cost});
    }
  }
}

StateSteps likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                            const std::function<PathCost(const Outcome&)>& cost) {
  return {graph, legality_threshold,
          [&](std::span<const Outcome> outcomes, std::vector<StateSteps::Step>& steps) {
            const Outcome& likeliest = outcomes.front();
            if (likeliest.shift != 0) steps.push_back({likeliest.shift, cost(likeliest)});
          }};
}

StateSteps likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                            double step_discount) {
  return likelySuccessors(graph, legality_threshold,
                          [step = toPathCost(-std::log1p(-step_discount))](const Outcome& outcome) {
                            return toPathCost(outcome.cost) + step;
                          });
}

StateSteps anyOutcomeSuccessors(const SymbolGraph& graph, double legality_threshold) {
  return {graph, legality_threshold,
          [](std::span<const Outcome> outcomes, std::vector<StateSteps::Step>& steps) {
            for (const Outcome& outcome : outcomes) {
              if (outcome.shift != 0) steps.push_back({outcome.shift, kNat});
            }
          }};
}

}  // namespace conceptplan
