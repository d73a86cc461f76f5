#include "action_schemas.hpp"

#include <algorithm>

#include "pddl_names.hpp"

namespace conceptplan {
namespace {

/// Puts together a schema; without changes it is left unfinished.
ActionSchema schemaOf(const SymbolGraph& graph, const PossibleStates& possible, Action action,
                      const MinimalTable& valid, const Determinisation& determinisation) {
  ActionSchema schema;
  schema.action = action;
  const PossibleStates from = possible.where(graph, action, determinisation.legality_threshold);
  std::vector<Symbols> next;
  std::vector<std::int64_t> costs;
  for (const StateId state : from.states) {
    const Transition& likeliest = graph.transitions(state, action).front();
    next.push_back(graph.symbols(likeliest.state));
    costs.push_back(wholeCost(likeliest, determinisation));
    schema.may_be_invalid = schema.may_be_invalid || !graph.valid(likeliest.state);
  }
  const std::vector<Concept> concepts = changingConcepts(graph);
  const ConceptCardinality cardinality = cardinalityOf(graph);
  for (const Concept which : concepts) {
    const std::size_t k = index(which);
    std::vector<std::int64_t> leads;
    bool changes = false;
    for (std::size_t i = 0; i < next.size(); ++i) {
      leads.push_back(static_cast<std::int64_t>(index(next[i][k])));
      changes = changes || next[i][k] != from.symbols[i][k];
    }
    if (!changes) continue;
    schema.changes.push_back(which);
    schema.leads.push_back(minimalTable(from.symbols, leads, concepts, cardinality));
  }
  if (schema.changes.empty()) return schema;
  schema.legal = legalTable(graph, possible, action, determinisation.legality_threshold);
  schema.cost = minimalTable(from.symbols, costs, concepts, cardinality);

  std::array<bool, kNumConcepts> named{};
  const auto add = [&named](const std::vector<Concept>& some) {
    for (const Concept which : some) named[index(which)] = true;
  };
  add(schema.changes);
  add(schema.legal.concepts);
  add(schema.cost.concepts);
  for (const MinimalTable& leads : schema.leads) add(leads.concepts);
  if (schema.may_be_invalid) add(valid.concepts);
  std::copy_if(kConcepts.begin(), kConcepts.end(), std::back_inserter(schema.parameters),
               [&named](Concept which) { return named[index(which)]; });
  return schema;
}

}  // namespace

PossibleStates::PossibleStates(const SymbolGraph& graph) {
  const StateId start = graph.mostProbableStart();
  for (std::size_t i = 0; i < graph.numStates() / graph.numReadings(); ++i) {
    const auto state = static_cast<StateId>(i);
    if (!graph.valid(state) && state != start) continue;
    states.push_back(state);
    symbols.push_back(graph.symbols(state));
  }
}

PossibleStates PossibleStates::where(const SymbolGraph& graph, Action action,
                                     double legality_threshold) const {
  PossibleStates legal;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (graph.legality(states[i], action) <= legality_threshold) continue;
    legal.states.push_back(states[i]);
    legal.symbols.push_back(symbols[i]);
  }
  return legal;
}

ActionSchemas::ActionSchemas(const SymbolGraph& graph, const Determinisation& determinisation)
    : valid(validTable(graph, false)) {
  const PossibleStates possible(graph);
  for (const Action action : kActions) {
    ActionSchema schema = schemaOf(graph, possible, action, valid, determinisation);
    if (!schema.changes.empty()) actions.push_back(std::move(schema));
  }
}

std::vector<std::string> ActionSchemas::arguments(Action action, const Symbols& before,
                                                  const Symbols& after) const {
  std::vector<std::string> names;
  for (const ActionSchema& schema : actions) {
    if (schema.action != action) continue;
    for (const Concept which : schema.parameters) {
      names.push_back(objectName(which, before[index(which)]));
      if (std::find(schema.changes.begin(), schema.changes.end(), which) != schema.changes.end()) {
        names.push_back(objectName(which, after[index(which)]));
      }
    }
  }
  return names;
}

std::vector<Concept> changingConcepts(const SymbolGraph& graph) {
  std::vector<Concept> concepts;
  for (const Concept which : kConcepts) {
    if (graph.mutability(which) == Mutability::kChanges) concepts.push_back(which);
  }
  return concepts;
}

ConceptCardinality cardinalityOf(const SymbolGraph& graph) {
  ConceptCardinality cardinality{};
  for (std::size_t k = 0; k < kNumConcepts; ++k) cardinality[k] = graph.problem().goal[k].size();
  return cardinality;
}

MinimalTable validTable(const SymbolGraph& graph, bool start_is_valid) {
  std::vector<Symbols> symbols;
  std::vector<std::int64_t> valid;
  for (std::size_t i = 0; i < graph.numStates() / graph.numReadings(); ++i) {
    const auto state = static_cast<StateId>(i);
    symbols.push_back(graph.symbols(state));
    valid.push_back(
        graph.valid(state) || (start_is_valid && state == graph.mostProbableStart()) ? 1 : 0);
  }
  return minimalTable(symbols, valid, changingConcepts(graph), cardinalityOf(graph));
}

MinimalTable legalTable(const SymbolGraph& graph, const PossibleStates& states, Action action,
                        double legality_threshold) {
  std::vector<std::int64_t> legal;
  for (const StateId state : states.states) {
    legal.push_back(graph.legality(state, action) > legality_threshold ? 1 : 0);
  }
  return minimalTable(states.symbols, legal, changingConcepts(graph), cardinalityOf(graph));
}

}  // namespace conceptplan
