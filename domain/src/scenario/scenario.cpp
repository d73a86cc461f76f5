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

const SymbolInput& symbolInputOf(const Scenario& scenario) {
  const auto* input = std::get_if<SymbolInput>(&scenario.input);
  if (!input) throw std::invalid_argument(scenario.name + ": the scenario is told in pictures");
  return *input;
}

std::vector<SymbolBelief> objectsOf(const Scenario& scenario,
                                    const std::array<std::size_t, kNumConcepts>& cardinality,
                                    std::vector<Fault>& faults) {
  const std::vector<GivenSymbols>& given = symbolInputOf(scenario).objects;
  std::vector<SymbolBelief> objects;
  for (std::size_t i = 0; i < given.size(); ++i) {
    objects.push_back(beliefOf(scenario, given[i], objectKey(i), cardinality, faults));
  }
  return objects;
}

/// Position of a target among the objects; adds a fault if there is no such object.
std::size_t positionOf(const Scenario& scenario, std::size_t target, const std::string& key,
                       std::vector<Fault>& faults) {
  const std::size_t objects = symbolInputOf(scenario).objects.size();
  if (target < 1 || target > objects) {
    faults.push_back(scenario.fault(key, "expected an object in [1, " + std::to_string(objects) +
                                             "], found " + std::to_string(target)));
  }
  return target - 1;
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
  const SymbolInput& input = symbolInputOf(scenario);
  if (!scenario.targets.empty()) {
    throw InputError({scenario.fault("targets", "several targets, where one is expected")});
  }
  std::vector<Fault> faults;
  SymbolicProblem problem;
  problem.initial.objects = objectsOf(scenario, cardinality, faults);
  problem.goal = beliefOf(scenario, input.goal, kGoalSymbolsKey, cardinality, faults);
  problem.initial.target = positionOf(scenario, scenario.target.value_or(1), "target", faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  return problem;
}

JointProblem jointProblemOf(const Scenario& scenario,
                            const std::array<std::size_t, kNumConcepts>& cardinality) {
  const SymbolInput& input = symbolInputOf(scenario);
  if (scenario.targets.empty() || input.goals.size() != scenario.targets.size()) {
    throw std::invalid_argument(scenario.name + ": " + std::to_string(input.goals.size()) +
                                " goals for " + std::to_string(scenario.targets.size()) +
                                " targets");
  }
  std::vector<Fault> faults;
  JointProblem problem;
  problem.objects = objectsOf(scenario, cardinality, faults);
  for (std::size_t i = 0; i < scenario.targets.size(); ++i) {
    problem.targets.push_back({positionOf(scenario, scenario.targets[i], "targets", faults),
                               beliefOf(scenario, input.goals[i], goalKey(i), cardinality, faults),
                               "object " + std::to_string(scenario.targets[i])});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return problem;
}

}  // namespace conceptplan
