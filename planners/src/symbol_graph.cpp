#include "conceptplan/planners/symbol_graph.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

#include "conceptplan/planners/belief_update.hpp"
#include "scene_readings.hpp"

namespace conceptplan {
namespace {

constexpr double kSumTolerance = 1e-6;

void checkBelief(const SymbolBelief& belief, const ConceptCardinality& cardinality,
                 const std::string& place) {
  for (const Concept which : kConcepts) {
    const std::vector<double>& row = belief[index(which)];
    const std::string where = place + ", " + std::string(name(which)) + ": ";
    if (row.size() != cardinality[index(which)]) {
      throw std::invalid_argument(where + "expected " + std::to_string(cardinality[index(which)]) +
                                  " symbols, found " + std::to_string(row.size()));
    }
    if (std::any_of(row.begin(), row.end(), [](double p) { return !(p >= 0); })) {
      throw std::invalid_argument(where + "a probability is negative or not a number");
    }
    const double sum = std::accumulate(row.begin(), row.end(), 0.0);
    if (!(std::abs(sum - 1) <= kSumTolerance)) {
      throw std::invalid_argument(where + "the probabilities sum to " + std::to_string(sum) +
                                  ", expected 1");
    }
  }
}

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

/// Marks the concepts that some action changes among these objects, in any state of the concepts
/// that the model can change at all.
void markChangeable(const SymbolicModel& model, Surroundings surroundings, double tolerance,
                    std::array<bool, kNumConcepts>& changeable) {
  std::vector<Concept> candidates;
  std::size_t combinations = 1;
  for (const Concept which : kConcepts) {
    if (!model.transitions.changes(which, tolerance)) continue;
    candidates.push_back(which);
    combinations *= model.cardinality()[index(which)];
  }
  for (std::size_t i = 0; i < combinations; ++i) {
    std::size_t rest = i;
    for (const Concept which : candidates) {
      const std::size_t symbols = model.cardinality()[index(which)];
      surroundings.target[index(which)] = static_cast<SymbolId>(rest % symbols);
      rest /= symbols;
    }
    for (const Action action : kActions) {
      if (!model.transitions.isDefined(action, surroundings)) continue;
      for (const Concept which : candidates) {
        const std::size_t own = index(surroundings.target[index(which)]);
        if (!changeable[index(which)] &&
            model.transitions.distribution(action, which, surroundings)[own] < 1 - tolerance) {
          changeable[index(which)] = true;
        }
      }
    }
  }
}

/// The verdict of each target. Targets that agree in the concepts on which the check depends are
/// asked for once; of the others' concepts, `among` has the values that are asked with.
/// @param checks is raised by the number of targets asked for.
std::vector<Verdict> verdictsOf(const std::vector<Symbols>& targets, const StateValidity& validity,
                                const Workbench& workbench, const Surroundings& among,
                                std::size_t& checks) {
  const std::array<bool, kNumConcepts> relevant = validity.dependsOn();
  std::map<Symbols, std::size_t> known;
  std::vector<Symbols> asked;
  std::vector<std::size_t> answer;  // [targets]
  for (Symbols target : targets) {
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      if (!relevant[k]) target[k] = among.target[k];
    }
    const auto [entry, is_new] = known.try_emplace(target, asked.size());
    if (is_new) asked.push_back(target);
    answer.push_back(entry->second);
  }
  checks += asked.size();
  const std::vector<Verdict> answers =
      validity.checkAll(workbench, among.grounding, asked, among.others);
  std::vector<Verdict> verdicts;
  for (const std::size_t i : answer) verdicts.push_back(answers[i]);
  return verdicts;
}

/// The next states of one action: the product of the effects on the single concepts.
/// @param first_state state of the reading whose concepts are all 0.
std::vector<Transition> jointTransitions(const SymbolicModel& model, Action action,
                                         const Surroundings& surroundings,
                                         const std::array<std::size_t, kNumConcepts>& stride,
                                         std::size_t first_state, double min_share) {
  std::vector<Transition> joint{{static_cast<StateId>(first_state), 1, 0}};
  for (const Concept which : kConcepts) {
    if (stride[index(which)] == 0) continue;
    const std::vector<double> next = model.transitions.distribution(action, which, surroundings);
    const double least = min_share * *std::max_element(next.begin(), next.end());
    std::vector<Transition> extended;
    for (const Transition& transition : joint) {
      for (std::size_t symbol = 0; symbol < next.size(); ++symbol) {
        if (next[symbol] <= 0 || next[symbol] < least) continue;
        extended.push_back(
            {static_cast<StateId>(index(transition.state) + symbol * stride[index(which)]),
             transition.probability * next[symbol], 0});
      }
    }
    joint = std::move(extended);
  }
  double sum = 0;
  for (const Transition& transition : joint) sum += transition.probability;
  for (Transition& transition : joint) {
    transition.probability /= sum;
    transition.cost = -std::log(transition.probability);
  }
  std::stable_sort(joint.begin(), joint.end(), [](const Transition& a, const Transition& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.state < b.state;
  });
  return joint;
}

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
  for (const SceneReading& reading : readings) {
    graph.reading_shares_.push_back(reading.share);
    markChangeable(model, {model.grounding, graph.frozen_, reading.others},
                   options.frozen_tolerance, changeable);
  }
  std::size_t states = 1;
  for (const Concept which : kConcepts) {
    const std::size_t k = index(which);
    if (!model.transitions.changes(which, options.frozen_tolerance)) {
      graph.mutability_[k] = Mutability::kNeverChanges;
    } else if (!changeable[k]) {
      graph.mutability_[k] = Mutability::kFrozenHere;
      graph.frozen_agreement_ *= agreement(graph.initialBelief()[k], problem.goal[k]);
    } else {
      graph.mutability_[k] = Mutability::kChanges;
      graph.stride_[k] = states;
      states *= graph.cardinality_[k];
    }
  }

  for (const SceneReading& reading : readings) {
    const Surroundings among{model.grounding, graph.frozen_, reading.others};
    const std::size_t first_state = graph.verdicts_.size();
    std::vector<Symbols> targets;
    for (std::size_t i = 0; i < states; ++i) {
      targets.push_back(graph.symbols(static_cast<StateId>(i)));
    }
    const std::vector<Verdict> verdicts =
        verdictsOf(targets, validity, problem.initial.workbench, among, graph.validity_checks_);
    graph.verdicts_.insert(graph.verdicts_.end(), verdicts.begin(), verdicts.end());
    for (const Symbols& target : targets) {
      const Surroundings here{among.grounding, target, among.others};
      for (const Action action : kActions) {
        const bool defined = model.transitions.isDefined(action, here);
        graph.legality_.push_back(defined ? model.legality.probability(action, here) : 0);
        graph.first_transition_.push_back(graph.transitions_.size());
        for (const Transition& transition :
             jointTransitions(model, action, here, graph.stride_, first_state, options.min_share)) {
          graph.transitions_.push_back(transition);
        }
      }
    }
  }
  graph.first_transition_.push_back(graph.transitions_.size());
  return graph;
}

}  // namespace conceptplan
