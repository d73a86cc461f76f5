#include "conceptplan/domain/scenario/scenario.hpp"

#include <stdexcept>

#include "symbol_keys.hpp"

namespace conceptplan {
namespace {

/// The belief that was given; adds a fault and returns an empty one if the model lacks the symbol.
SymbolBelief beliefOf(const Scenario& scenario, const GivenSymbols& given, const std::string& key,
                      const std::array<std::size_t, kNumConcepts>& cardinality,
                      std::vector<Fault>& faults) {
  SymbolBelief belief;
  for (const Concept which : kConcepts) {
    const std::size_t count = cardinality[index(which)];
    std::vector<double>& distribution = belief[index(which)];
    const std::string full = key + "." + symbolKey(which);
    if (const auto* symbol = std::get_if<SymbolId>(&given[index(which)])) {
      if (index(*symbol) < count) {
        distribution.assign(count, 0.0);
        distribution[index(*symbol)] = 1.0;
      } else {
        faults.push_back(scenario.fault(full, "expected a symbol of the model, in [0, " +
                                                  std::to_string(count) + "), found " +
                                                  std::to_string(index(*symbol))));
      }
      continue;
    }
    distribution = std::get<std::vector<double>>(given[index(which)]);
    if (distribution.size() != count) {
      faults.push_back(scenario.fault(full, "expected one probability for each of the model's " +
                                                std::to_string(count) + " symbols, found " +
                                                std::to_string(distribution.size())));
    }
  }
  return belief;
}

}  // namespace

Fault Scenario::fault(const std::string& key, const std::string& message) const {
  Fault result{file.string(), {}, {}, key, message};
  const auto found = positions.find(key);
  if (found != positions.end()) {
    result.line = found->second.line;
    result.column = found->second.column;
  }
  return result;
}

SymbolicProblem problemOf(const Scenario& scenario,
                          const std::array<std::size_t, kNumConcepts>& cardinality) {
  const auto* input = std::get_if<SymbolInput>(&scenario.input);
  if (!input) throw std::invalid_argument(scenario.name + ": the scenario is told in pictures");
  std::vector<Fault> faults;
  SymbolicProblem problem;
  for (std::size_t i = 0; i < input->objects.size(); ++i) {
    problem.initial.objects.push_back(
        beliefOf(scenario, input->objects[i], objectKey(i), cardinality, faults));
  }
  problem.goal = beliefOf(scenario, input->goal, kGoalSymbolsKey, cardinality, faults);
  const std::size_t target = scenario.target.value_or(1);
  if (target < 1 || target > input->objects.size()) {
    faults.push_back(scenario.fault("target", "expected an object in [1, " +
                                                  std::to_string(input->objects.size()) +
                                                  "], found " + std::to_string(target)));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  problem.initial.target = target - 1;
  return problem;
}

}  // namespace conceptplan
