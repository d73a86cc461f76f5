#include "sparse_belief.hpp"

#include <algorithm>

#include "graph_tables.hpp"

namespace conceptplan {
namespace {

bool byState(const Mass& a, const Mass& b) { return a.state < b.state; }

/// Sorts and adds up what falls to the same state, in the order in which it came.
SparseBelief gathered(SparseBelief masses) {
  if (masses.empty()) return masses;
  std::stable_sort(masses.begin(), masses.end(), byState);
  auto last = masses.begin();
  for (auto mass = last + 1; mass != masses.end(); ++mass) {
    if (mass->state == last->state) {
      last->mass += mass->mass;
    } else {
      *++last = *mass;
    }
  }
  masses.erase(last + 1, masses.end());
  return masses;
}

}  // namespace

SparseBelief sparse(const StateBelief& belief) {
  SparseBelief masses;
  for (std::size_t i = 0; i < belief.size(); ++i) {
    if (belief[i] > 0) masses.push_back({static_cast<StateId>(i), belief[i]});
  }
  return masses;
}

StateBelief dense(const SparseBelief& belief, std::size_t num_states) {
  StateBelief states(num_states, 0);
  for (const Mass& entry : belief) states[index(entry.state)] = entry.mass;
  return states;
}

SparseBelief sparseStateBelief(const SymbolGraph& graph, const SymbolBelief& belief) {
  const SymbolIndex& states = graph.tables().states;
  SparseBelief masses{{StateId{0}, 1}};
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (!states.has(k)) continue;
    SparseBelief longer;
    for (const Mass& before : masses) {
      for (std::size_t symbol = 0; symbol < belief[k].size(); ++symbol) {
        const double mass = before.mass * belief[k][symbol];
        if (mass <= 0) continue;
        longer.push_back(
            {static_cast<StateId>(index(before.state) + symbol * states.stride(k)), mass});
      }
    }
    masses = std::move(longer);
  }
  std::sort(masses.begin(), masses.end(), byState);
  const std::size_t of_reading = masses.size();
  for (std::size_t reading = 1; reading < graph.numReadings(); ++reading) {
    for (std::size_t i = 0; i < of_reading; ++i) {
      masses.push_back({graph.inReading(masses[i].state, reading), masses[i].mass});
    }
  }
  return masses;
}

SparseBelief propagateLegal(const SymbolGraph& graph, const SparseBelief& belief, Action action,
                            double threshold) {
  SparseBelief next;
  for (const Mass& entry : belief) {
    const StateActions actions(graph, entry.state);
    if (actions.legality(action) <= threshold) continue;
    for (const Transition& outcome : actions.transitions(action)) {
      next.push_back({outcome.state, entry.mass * outcome.probability});
    }
  }
  return gathered(std::move(next));
}

void keepValid(const SymbolGraph& graph, SparseBelief& belief) {
  std::erase_if(belief, [&](const Mass& entry) { return !graph.valid(entry.state); });
}

double normalize(SparseBelief& belief) {
  double sum = 0;
  for (const Mass& entry : belief) sum += entry.mass;
  if (sum > 0) {
    for (Mass& entry : belief) entry.mass /= sum;
  }
  return sum;
}

double agreement(const SparseBelief& belief, const SparseBelief& goal) {
  double sum = 0;
  auto wanted = goal.begin();
  for (const Mass& entry : belief) {
    wanted = std::lower_bound(wanted, goal.end(), entry, byState);
    if (wanted == goal.end()) break;
    if (wanted->state == entry.state) sum += entry.mass * wanted->mass;
  }
  return sum;
}

SparseBelief sparseStartBelief(const SymbolGraph& graph, const SymbolBelief& belief) {
  SparseBelief all = sparseStateBelief(graph, belief);
  for (Mass& entry : all) entry.mass *= graph.readingShare(graph.readingOf(entry.state));
  SparseBelief valid = all;
  keepValid(graph, valid);
  return normalize(valid) > 0 ? valid : all;
}

PlanProbability probabilityOf(const SymbolGraph& graph, const ActionSequence& actions,
                              const SparseBelief& start, const SparseBelief& goal,
                              double threshold) {
  SparseBelief belief = start;
  double survived = 1;
  for (const Action action : actions) {
    belief = propagateLegal(graph, belief, action, threshold);
    keepValid(graph, belief);
    survived *= normalize(belief);
  }
  const double conditional = agreement(belief, goal) * graph.frozenAgreement();
  return {survived * conditional, conditional};
}

}  // namespace conceptplan
