#include "conceptplan/planners/symbol_graph.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "belief_check.hpp"
#include "conceptplan/planners/belief_update.hpp"
#include "model_tables.hpp"
#include "scene_readings.hpp"

namespace conceptplan {
namespace {

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

/// The next states of single actions: products of the outcomes of the single concepts.
class JointOutcomes {
 public:
  JointOutcomes(const ModelTables& tables, const std::array<std::size_t, kNumConcepts>& stride)
      : tables_(tables), stride_(stride) {}

  /// By falling probability, ties by state; sums to one. Holds until the next call.
  /// @param first_state state of the reading whose concepts are all 0.
  const std::vector<Transition>& of(Action action, const Symbols& target, std::size_t first_state) {
    joint_.assign(1, {static_cast<StateId>(first_state), 1, 0});
    for (const Concept which : kConcepts) {
      if (stride_[index(which)] != 0) {
        extend(tables_.outcomes(action, which, target), stride_[index(which)]);
      }
    }
    double sum = 0;
    for (const Transition& transition : joint_) sum += transition.probability;
    for (Transition& transition : joint_) {
      transition.probability /= sum;
      transition.cost = -std::log(transition.probability);
    }
    std::sort(joint_.begin(), joint_.end(), [](const Transition& a, const Transition& b) {
      return a.probability != b.probability ? a.probability > b.probability : a.state < b.state;
    });
    return joint_;
  }

 private:
  /// Each transition so far with each outcome of one more concept.
  void extend(const std::vector<SymbolOutcome>& outcomes, std::size_t stride) {
    extended_.clear();
    for (const Transition& transition : joint_) {
      for (const SymbolOutcome& outcome : outcomes) {
        extended_.push_back(
            {static_cast<StateId>(index(transition.state) + outcome.symbol * stride),
             transition.probability * outcome.probability, 0});
      }
    }
    std::swap(joint_, extended_);
  }

  const ModelTables& tables_;
  const std::array<std::size_t, kNumConcepts>& stride_;
  std::vector<Transition> joint_;
  std::vector<Transition> extended_;
};

}  // namespace

Symbols SymbolGraph::symbols(StateId state) const {
  Symbols symbols = frozen_;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (stride_[k] != 0) {
      symbols[k] = static_cast<SymbolId>(index(state) / stride_[k] % cardinality_[k]);
    }
  }
  return symbols;
}

StateId SymbolGraph::state(const Symbols& symbols) const {
  std::size_t packed = 0;
  for (std::size_t k = 0; k < kNumConcepts; ++k) packed += index(symbols[k]) * stride_[k];
  return static_cast<StateId>(packed);
}

SymbolGraph SymbolGraph::between(StateId start, StateId goal) const {
  SymbolGraph graph = *this;
  graph.problem_.initial.objects[problem_.initial.target] = certain(symbols(start), cardinality_);
  graph.problem_.goal = certain(symbols(goal), cardinality_);
  graph.frozen_agreement_ = 1;
  return graph;
}

std::span<const Transition> SymbolGraph::transitions(StateId state, Action action) const {
  const std::size_t first = first_transition_[edge(state, action)];
  return std::span(transitions_).subspan(first, first_transition_[edge(state, action) + 1] - first);
}

std::vector<double> SymbolGraph::stateBelief(const SymbolBelief& belief) const {
  std::vector<double> states(numStates(), 1);
  for (std::size_t i = 0; i < states.size(); ++i) {
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      if (stride_[k] != 0) states[i] *= belief[k][i / stride_[k] % cardinality_[k]];
    }
  }
  return states;
}

SymbolGraph compile(const SymbolicModel& model, const SymbolicProblem& problem,
                    const StateValidity& validity, const CompileOptions& options) {
  checkProblem(problem, model.cardinality());
  if (options.max_readings == 0) throw std::invalid_argument("max_readings is 0, expected >= 1");
  SymbolGraph graph;
  graph.problem_ = problem;
  graph.cardinality_ = model.cardinality();
  graph.frozen_ = mostProbable(graph.initialBelief());
  const std::vector<SceneReading> readings = probableReadings(model, problem.initial, options);

  std::array<bool, kNumConcepts> changeable{};
  for (const Concept which : kConcepts) {
    changeable[index(which)] = model.transitions.changes(which, options.frozen_tolerance);
  }
  std::vector<ModelTables> tables;
  for (const SceneReading& reading : readings) {
    graph.reading_shares_.push_back(reading.share);
    tables.emplace_back(model, Surroundings{model.grounding, graph.frozen_, reading.others},
                        changeable, options.min_share);
  }
  std::size_t states = 1;
  for (const Concept which : kConcepts) {
    const std::size_t k = index(which);
    if (!changeable[k]) {
      graph.mutability_[k] = Mutability::kNeverChanges;
    } else if (std::none_of(tables.begin(), tables.end(), [&](const ModelTables& table) {
                 return table.changes(which, options.frozen_tolerance);
               })) {
      graph.mutability_[k] = Mutability::kFrozenHere;
      graph.frozen_agreement_ *= agreement(graph.initialBelief()[k], problem.goal[k]);
    } else {
      graph.mutability_[k] = Mutability::kChanges;
      graph.stride_[k] = states;
      states *= graph.cardinality_[k];
    }
  }

  const std::size_t all_states = states * readings.size();
  graph.verdicts_.reserve(all_states);
  graph.legality_.reserve(all_states * kNumActions);
  graph.first_transition_.reserve(all_states * kNumActions + 1);
  graph.transitions_.reserve(all_states * kNumActions);
  std::array<bool, kNumConcepts> checked = validity.dependsOn();
  for (std::size_t k = 0; k < kNumConcepts; ++k) checked[k] = checked[k] && graph.stride_[k] != 0;
  for (std::size_t reading = 0; reading < readings.size(); ++reading) {
    // One check serves all states that agree in the concepts on which validity depends.
    std::vector<Symbols> asked;
    const SymbolTable<std::size_t> check(checked, graph.cardinality_, graph.frozen_,
                                         [&](const Symbols& target) {
                                           asked.push_back(target);
                                           return asked.size() - 1;
                                         });
    const std::vector<Verdict> verdicts = validity.checkAll(
        problem.initial.workbench, model.grounding, asked, readings[reading].others);
    graph.validity_checks_ += asked.size();
    JointOutcomes joint(tables[reading], graph.stride_);
    for (std::size_t i = 0; i < states; ++i) {
      const Symbols target = graph.symbols(static_cast<StateId>(i));
      graph.verdicts_.push_back(verdicts[check[target]]);
      for (const Action action : kActions) {
        graph.legality_.push_back(tables[reading].legality(action, target));
        graph.first_transition_.push_back(graph.transitions_.size());
        const std::vector<Transition>& next = joint.of(action, target, reading * states);
        graph.transitions_.insert(graph.transitions_.end(), next.begin(), next.end());
      }
    }
  }
  graph.first_transition_.push_back(graph.transitions_.size());
  return graph;
}

}  // namespace conceptplan
