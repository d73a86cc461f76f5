#include "conceptplan/domain/model/transition_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

constexpr double kSumTolerance = 1e-9;

std::size_t jointValueCount(std::span<const ContextFeature> features,
                            const ConceptCardinality& cardinality) {
  std::size_t count = 1;
  for (const ContextFeature& feature : features) count *= valueCount(feature, cardinality);
  return count;
}

void checkEffect(const Effect& effect, Action action, Concept which,
                 const ConceptCardinality& cardinality) {
  const std::string place =
      "effect of " + std::string(name(action)) + " on " + std::string(name(which)) + ": ";
  if (!(effect.stays >= 0 && effect.stays <= 1)) {
    throw std::invalid_argument(place + "stays " + std::to_string(effect.stays) +
                                " is not in [0, 1]");
  }
  for (const auto& [joint, row] : effect.rows) {
    if (joint >= jointValueCount(effect.context, cardinality)) {
      throw std::invalid_argument(place + "context value " + std::to_string(joint) +
                                  " is out of range");
    }
    if (row.size() != cardinality[index(which)]) {
      throw std::invalid_argument(place + "a row has " + std::to_string(row.size()) +
                                  " symbols, expected " +
                                  std::to_string(cardinality[index(which)]));
    }
    double sum = 0;
    for (const double probability : row) {
      if (!(probability >= 0)) {
        throw std::invalid_argument(place + "a row has the probability " +
                                    std::to_string(probability));
      }
      sum += probability;
    }
    if (!(std::abs(sum - 1) < kSumTolerance)) {
      throw std::invalid_argument(place + "a row sums to " + std::to_string(sum) + ", expected 1");
    }
  }
}

/// The distribution over the other symbols if one symbol stays with that probability.
std::vector<double> staying(std::size_t symbol, double probability, std::size_t symbols) {
  if (symbols == 1) return {1.0};
  std::vector<double> row(symbols, (1 - probability) / static_cast<double>(symbols - 1));
  row[symbol] = probability;
  return row;
}

/// The most that a row takes away from the symbol that its context tells, if it tells one.
double changeOfRow(const Effect& effect, Concept which, const ConceptCardinality& cardinality,
                   std::size_t joint, const std::vector<double>& row) {
  const std::vector<std::size_t> values = splitJointValue(effect.context, cardinality, joint);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ContextFeature& feature = effect.context[i];
    if (feature.kind == ContextKind::kOwnSymbol && feature.which == which) {
      return 1 - row[values[i]];
    }
  }
  return 1;  // the next symbol does not follow from the own one
}

/// The most of all contexts seen.
double changeOf(const Effect& effect, Concept which, const ConceptCardinality& cardinality) {
  if (effect.rows.empty()) return 1 - effect.stays;
  double most = 0;
  for (const auto& [joint, row] : effect.rows) {
    most = std::max(most, changeOfRow(effect, which, cardinality, joint, row));
  }
  return most;
}

}  // namespace

void ContextCounts::add(std::size_t joint_value, std::size_t outcome, std::size_t outcomes) {
  std::vector<double>& row = rows[joint_value];
  row.resize(outcomes, 0);
  row[outcome] += 1;
}

TransitionModel::TransitionModel(const ConceptCardinality& cardinality, EffectTable effects)
    : cardinality_(cardinality), effects_(std::move(effects)) {
  for (const Concept which : kConcepts) {
    if (cardinality_[index(which)] == 0) {
      throw std::invalid_argument("cardinality of " + std::string(name(which)) + " is 0");
    }
  }
  for (const Action action : kActions) {
    for (const Concept which : kConcepts) {
      checkEffect(effect(action, which), action, which, cardinality_);
      double& greatest = greatest_change_[index(which)];
      greatest = std::max(greatest, changeOf(effect(action, which), which, cardinality_));
    }
  }
}

std::vector<double> TransitionModel::distribution(Action action, Concept which,
                                                  const Surroundings& surroundings) const {
  return distribution(action, which,
                      jointValueOf(effect(action, which).context, cardinality_, surroundings),
                      surroundings.target[index(which)]);
}

std::vector<double> TransitionModel::distribution(Action action, Concept which,
                                                  std::size_t joint_value, SymbolId own) const {
  const Effect& rule = effect(action, which);
  const auto row = rule.rows.find(joint_value);
  if (row != rule.rows.end()) return row->second;
  return staying(index(own), rule.stays, cardinality_[index(which)]);
}

bool TransitionModel::isDefined(Action action, const Surroundings& surroundings) const {
  for (const Concept which : kConcepts) {
    for (const ContextFeature& feature : effect(action, which).context) {
      if (isAbsent(feature, cardinality_, valueOf(feature, cardinality_, surroundings))) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace conceptplan
