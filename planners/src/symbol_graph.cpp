#include "conceptplan/planners/symbol_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "belief_check.hpp"
#include "conceptplan/planners/belief_update.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "graph_tables.hpp"
#include "scene_readings.hpp"

namespace conceptplan {
namespace {

/// States whose validity is asked for between two looks at the limits.
constexpr std::size_t kCheckedAtOnce = 1024;

void checkProblem(const SymbolicProblem& problem, const ConceptCardinality& cardinality) {
  const SymbolicScene& scene = problem.initial;
  if (scene.target >= scene.objects.size()) {
    throw std::invalid_argument("the target is object " + std::to_string(scene.target) + " of " +
                                std::to_string(scene.objects.size()));
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    checkBelief(scene.objects[i], cardinality, "object " + std::to_string(i));
  }
  checkBelief(problem.goal, cardinality, "goal");
}

using ActionsOfReading = std::array<std::shared_ptr<const ActionTables>, kNumActions>;

/// What the model says of the actions in each reading; actions that do not depend on the other
/// objects are shared. Incomplete once the guard has been stopped.
std::vector<ActionsOfReading> actionTables(const SymbolicModel& model,
                                           const std::vector<SceneReading>& readings,
                                           const Symbols& target, const ConceptSet& changeable,
                                           double min_share, SearchGuard& guard) {
  std::vector<ActionsOfReading> tables(readings.size());
  for (const Action action : kActions) {
    const bool is_shared = !dependsOnOthers(model, action);
    for (std::size_t i = 0; i < readings.size(); ++i) {
      tables[i][index(action)] =
          is_shared && i > 0
              ? tables.front()[index(action)]
              : std::make_shared<const ActionTables>(
                    model, action, Surroundings{model.grounding, target, readings[i].others},
                    changeable, min_share, guard);
    }
  }
  return tables;
}

bool changesHere(const std::vector<ActionsOfReading>& tables, Concept which, double tolerance) {
  return std::any_of(tables.begin(), tables.end(), [&](const ActionsOfReading& actions) {
    return std::any_of(actions.begin(), actions.end(),
                       [&](const auto& action) { return action->changes(which, tolerance); });
  });
}

/// Sets which concepts are part of the states.
void setStates(const std::vector<ActionsOfReading>& tables, const ConceptSet& changeable,
               double tolerance, GraphTables& graph) {
  ConceptSet part_of_states{};
  for (const Concept which : kConcepts) {
    Mutability& mutability = graph.mutability[index(which)];
    if (!changeable[index(which)]) {
      mutability = Mutability::kNeverChanges;
    } else if (!changesHere(tables, which, tolerance)) {
      mutability = Mutability::kFrozenHere;
    } else {
      mutability = Mutability::kChanges;
      part_of_states[index(which)] = true;
    }
  }
  graph.states = {part_of_states, graph.cardinality};
  const std::size_t states = graph.states.size() * tables.size();
  if (states > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw std::invalid_argument("the problem has " + std::to_string(states) +
                                " states, more than can be numbered");
  }
}

void compileActions(const std::vector<ActionsOfReading>& tables, GraphTables& graph,
                    SearchGuard& guard) {
  for (std::size_t i = 0; i < tables.size(); ++i) {
    for (std::size_t action = 0; action < kNumActions; ++action) {
      const bool is_shared = i > 0 && tables[i][action] == tables.front()[action];
      graph.readings[i].actions[action] =
          is_shared ? graph.readings.front().actions[action]
                    : std::make_shared<const CompiledAction>(*tables[i][action], graph.states,
                                                             graph.cardinality, graph.fixed, guard);
    }
  }
}

/// One check serves all states that agree in the concepts on which validity depends.
void checkStates(const SymbolicModel& model, const Workbench& workbench,
                 const StateValidity& validity, const std::vector<SceneReading>& readings,
                 GraphTables& graph, SearchGuard& guard) {
  ConceptSet checked = validity.dependsOn();
  for (std::size_t k = 0; k < kNumConcepts; ++k) checked[k] = checked[k] && graph.states.has(k);
  graph.checked = {checked, graph.cardinality};
  std::vector<Symbols> targets;
  targets.reserve(graph.checked.size());
  graph.checked.forEach(graph.fixed, [&](const Symbols& target) { targets.push_back(target); });
  graph.valid.reserve(graph.states.size() * readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    std::vector<Verdict>& verdicts = graph.readings[i].verdicts;
    verdicts.reserve(targets.size());
    for (std::span<const Symbols> rest = targets; !rest.empty();) {
      if (!guard.goesOn()) return;
      const std::size_t count = std::min(rest.size(), kCheckedAtOnce);
      const std::vector<Verdict> more =
          validity.checkAll(workbench, model.grounding, rest.first(count), readings[i].others);
      verdicts.insert(verdicts.end(), more.begin(), more.end());
      rest = rest.subspan(count);
    }
    graph.states.forEach(graph.fixed, [&](const Symbols& target) {
      graph.valid.push_back(verdicts[graph.checked(target)].valid() ? 1 : 0);
    });
  }
}

}  // namespace

std::size_t SymbolGraph::numStates() const { return tables_->valid.size(); }

Mutability SymbolGraph::mutability(Concept which) const {
  return tables_->mutability[index(which)];
}

std::size_t SymbolGraph::validityChecks() const { return tables_->checked.size() * numReadings(); }

Symbols SymbolGraph::symbols(StateId state) const { return tables_->symbols(state); }

StateId SymbolGraph::state(const Symbols& symbols) const {
  return static_cast<StateId>(tables_->states(symbols));
}

std::size_t SymbolGraph::numReadings() const { return tables_->readings.size(); }

std::size_t SymbolGraph::readingOf(StateId state) const { return tables_->readingOf(state); }

double SymbolGraph::readingShare(std::size_t reading) const {
  return tables_->readings[reading].share;
}

StateId SymbolGraph::inReading(StateId state, std::size_t reading) const {
  const std::size_t states = tables_->states.size();
  return static_cast<StateId>(index(state) % states + reading * states);
}

SymbolGraph SymbolGraph::between(StateId start, StateId goal) const {
  SymbolGraph graph = *this;
  graph.problem_.initial.objects[problem_.initial.target] =
      certain(symbols(start), tables_->cardinality);
  graph.problem_.goal = certain(symbols(goal), tables_->cardinality);
  graph.frozen_agreement_ = 1;
  return graph;
}

const Verdict& SymbolGraph::verdict(StateId state) const {
  return tables_->readings[readingOf(state)].verdicts[tables_->checked(symbols(state))];
}

bool SymbolGraph::valid(StateId state) const { return tables_->valid[index(state)] != 0; }

double SymbolGraph::legality(StateId state, Action action) const {
  return StateActions(*this, state).legality(action);
}

TransitionRange SymbolGraph::transitions(StateId state, Action action) const {
  return StateActions(*this, state).transitions(action);
}

std::vector<double> SymbolGraph::stateBelief(const SymbolBelief& belief) const {
  std::vector<double> states;
  states.reserve(numStates());
  tables_->states.forEach(tables_->fixed, [&](const Symbols& symbols) {
    double probability = 1;
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      if (tables_->states.has(k)) probability *= belief[k][index(symbols[k])];
    }
    states.push_back(probability);
  });
  const auto of_reading = static_cast<std::ptrdiff_t>(states.size());
  for (std::size_t i = 1; i < numReadings(); ++i) {
    states.insert(states.end(), states.begin(), states.begin() + of_reading);
  }
  return states;
}

SymbolGraph compile(const SymbolicModel& model, const SymbolicProblem& problem,
                    const StateValidity& validity, const CompileOptions& options) {
  SearchLimits none;
  none.timeout_s = std::numeric_limits<double>::infinity();
  SearchGuard guard(none);
  return *compile(model, problem, validity, guard, options);
}

std::optional<SymbolGraph> compile(const SymbolicModel& model, const SymbolicProblem& problem,
                                   const StateValidity& validity, SearchGuard& guard,
                                   const CompileOptions& options) {
  checkProblem(problem, model.cardinality());
  if (options.max_readings == 0) throw std::invalid_argument("max_readings is 0, expected >= 1");
  SymbolGraph graph;
  graph.problem_ = problem;
  const auto tables = std::make_shared<GraphTables>();
  tables->cardinality = model.cardinality();
  tables->fixed = mostProbable(graph.initialBelief());

  const std::vector<SceneReading> readings = probableReadings(model, problem.initial, options);
  for (const SceneReading& reading : readings) {
    tables->readings.push_back({reading.share, {}, {}});
  }
  ConceptSet changeable{};
  for (const Concept which : kConcepts) {
    changeable[index(which)] = model.transitions.changes(which, options.frozen_tolerance);
  }
  const auto actions =
      actionTables(model, readings, tables->fixed, changeable, options.min_share, guard);
  if (guard.stopped()) return std::nullopt;
  setStates(actions, changeable, options.frozen_tolerance, *tables);
  compileActions(actions, *tables, guard);
  if (guard.stopped()) return std::nullopt;
  checkStates(model, problem.initial.workbench, validity, readings, *tables, guard);
  if (guard.stopped()) return std::nullopt;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (tables->mutability[k] == Mutability::kFrozenHere) {
      graph.frozen_agreement_ *= agreement(graph.initialBelief()[k], problem.goal[k]);
    }
  }
  graph.tables_ = tables;
  return graph;
}

}  // namespace conceptplan
