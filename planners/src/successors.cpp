#include "successors.hpp"

#include <cmath>

namespace conceptplan {
namespace {

auto discountedCost(double step_discount) {
  return [step = toPathCost(-std::log1p(-step_discount))](const Outcome& outcome) {
    return toPathCost(outcome.cost) + step;
  };
}

bool goesOn(SearchGuard* guard) { return guard == nullptr || guard->goesOn(); }

}  // namespace

StateSteps::StateSteps(const SymbolGraph& graph, double legality_threshold, const Choice& choice,
                       SearchGuard* guard)
    : graph_(graph.tables()) {
  for (const GraphTables::Reading& reading : graph_.readings) {
    std::vector<ContextSteps>& of_reading = steps_.emplace_back();
    for (std::size_t begin = 0, end = 0; begin < kNumActions; begin = end) {
      ContextSteps all{reading.actions[begin]->contexts(), {0}, {}};
      while (end < kNumActions && reading.actions[end]->contexts() == all.contexts) ++end;
      all.contexts.forEach(graph_.fixed, [&](const Symbols& symbols) {
        const std::size_t last = goesOn(guard) ? end : begin;
        for (std::size_t a = begin; a < last; ++a) {
          const CompiledAction& compiled = *reading.actions[a];
          if (compiled.legality(symbols) <= legality_threshold) continue;
          choice(kActions[a], compiled.outcomes(symbols), all.steps);
        }
        all.first.push_back(static_cast<std::uint32_t>(all.steps.size()));
      });
      if (!all.steps.empty()) of_reading.push_back(std::move(all));
    }
  }
}

StateSteps StateSteps::atCosts(std::size_t reading,
                               const std::function<PathCost(std::size_t from, const Step&)>& cost,
                               SearchGuard* guard) const {
  StateSteps others(graph_);
  for (const ContextSteps& all : steps_[reading]) {
    ContextSteps changed{all.contexts, {0}, {}};
    all.contexts.forEach(Symbols{}, [&](const Symbols& symbols) {
      const std::size_t context = changed.first.size() - 1;
      for (std::uint32_t i = all.first[context]; i < all.first[context + 1] && goesOn(guard); ++i) {
        Step step = all.steps[i];
        step.cost = cost(graph_.states(symbols), step);
        if (step.cost != kOutOfReach) changed.steps.push_back(step);
      }
      changed.first.push_back(static_cast<std::uint32_t>(changed.steps.size()));
    });
    others.steps_[reading].push_back(std::move(changed));
  }
  return others;
}

StateSteps likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                            const std::function<PathCost(const Outcome&)>& cost,
                            SearchGuard* guard) {
  return {
      graph, legality_threshold,
      [&](Action action, std::span<const Outcome> outcomes, std::vector<StateSteps::Step>& steps) {
        const Outcome& likeliest = outcomes.front();
        if (likeliest.shift != 0) steps.push_back({action, likeliest.shift, cost(likeliest)});
      },
      guard};
}

StateSteps likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                            double step_discount, SearchGuard* guard) {
  return likelySuccessors(graph, legality_threshold, discountedCost(step_discount), guard);
}

StateSteps rankedSuccessors(const SymbolGraph& graph, double legality_threshold,
                            double step_discount, SearchGuard* guard) {
  return likelySuccessors(
      graph, legality_threshold,
      [cost = discountedCost(step_discount)](const Outcome& outcome) {
        return rankOf(cost(outcome), 1);
      },
      guard);
}

StateSteps anyOutcomeSuccessors(const SymbolGraph& graph, double legality_threshold,
                                SearchGuard* guard) {
  return {
      graph, legality_threshold,
      [](Action action, std::span<const Outcome> outcomes, std::vector<StateSteps::Step>& steps) {
        for (const Outcome& outcome : outcomes) {
          if (outcome.shift != 0) steps.push_back({action, outcome.shift, kNat});
        }
      },
      guard};
}

}  // namespace conceptplan
