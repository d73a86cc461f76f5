#include "joint_target.hpp"

#include <algorithm>
#include <utility>

#include "model_tables.hpp"

namespace conceptplan {
namespace {

/// TYPE symbols of objects of which it is open where they are and what symbols they have.
using OpenTypes = std::vector<bool>;

bool isOpen(const ContextFeature& feature, const OpenTypes& open) {
  return feature.kind != ContextKind::kOwnSymbol && open[index(feature.type)];
}

/// Pr[a | Omega], the greatest that it may be.
double legalityOf(const SymbolicModel& model, Action action, const Surroundings& surroundings,
                  const OpenTypes& open) {
  const std::vector<LegalityFactor>& factors = model.legality.factors(action);
  if (factors.empty()) return ActionLegality::kPriorShare;
  double least = 1;
  for (const LegalityFactor& factor : factors) {
    least = std::min(
        least, isOpen(factor.context, open)
                   ? *std::max_element(factor.share.begin(), factor.share.end())
                   : factor.share[valueOf(factor.context, model.cardinality(), surroundings)]);
  }
  return least;
}

/// The joint values that the context of an effect may have.
std::vector<std::size_t> possibleContexts(const std::vector<ContextFeature>& context,
                                          const ConceptCardinality& cardinality,
                                          const Surroundings& surroundings, const OpenTypes& open) {
  std::vector<std::size_t> contexts{0};
  for (const ContextFeature& feature : context) {
    const std::size_t count = valueCount(feature, cardinality);
    std::vector<std::size_t> longer;
    if (!isOpen(feature, open)) {
      const std::size_t value = valueOf(feature, cardinality, surroundings);
      for (const std::size_t before : contexts) longer.push_back(before * count + value);
    } else {
      for (const std::size_t before : contexts) {
        for (std::size_t value = 0; value < count; ++value) {
          longer.push_back(before * count + value);
        }
      }
    }
    contexts = std::move(longer);
  }
  return contexts;
}

/// What one action may do to one concept.
struct ConceptOutcomes {
  /// The most probable next symbols of the possible contexts, each with its greatest probability.
  std::vector<SymbolOutcome> likeliest;
  double change = 0;  ///< greatest Pr[the symbol does not stay]
};

ConceptOutcomes outcomesOf(const SymbolicModel& model, Action action, Concept which,
                           const Surroundings& surroundings, const OpenTypes& open,
                           double min_share) {
  const SymbolId own = surroundings.target[index(which)];
  ConceptOutcomes outcomes;
  for (const std::size_t context : possibleContexts(model.transitions.effect(action, which).context,
                                                    model.cardinality(), surroundings, open)) {
    const std::vector<double> next = model.transitions.distribution(action, which, context, own);
    const auto best = std::max_element(next.begin(), next.end());
    double kept = 0;
    for (const double probability : next)
      kept += probability >= min_share * *best ? probability : 0;
    const auto symbol = static_cast<std::size_t>(best - next.begin());
    const auto known =
        std::find_if(outcomes.likeliest.begin(), outcomes.likeliest.end(),
                     [symbol](const SymbolOutcome& outcome) { return outcome.symbol == symbol; });
    if (known == outcomes.likeliest.end()) {
      outcomes.likeliest.push_back({symbol, *best / kept});
    } else {
      known->probability = std::max(known->probability, *best / kept);
    }
    outcomes.change = std::max(outcomes.change, 1 - next[index(own)]);
  }
  return outcomes;
}

/// All features on which what actions do may depend, but for concepts that never change.
std::vector<ContextFeature> featuresOf(const SymbolicModel& model, const ConceptSet& changeable) {
  std::vector<ContextFeature> features;
  for (const Action action : kActions) {
    for (const LegalityFactor& factor : model.legality.factors(action)) {
      features.push_back(factor.context);
    }
    for (const Concept which : kConcepts) {
      if (!changeable[index(which)]) continue;
      const std::vector<ContextFeature>& context = model.transitions.effect(action, which).context;
      features.insert(features.end(), context.begin(), context.end());
    }
  }
  return features;
}

/// The concepts of the target on which an effect depends, its own included.
ConceptSet dependence(const std::vector<ContextFeature>& context, Concept which,
                      const ConceptSet& changeable, const OpenTypes& open) {
  ConceptSet depends{};
  depends[index(which)] = true;
  for (const ContextFeature& feature : context) {
    if (feature.kind == ContextKind::kOwnSymbol) {
      depends[index(feature.which)] = changeable[index(feature.which)];
    } else if (!isOpen(feature, open)) {
      depends[index(Concept::kPositionX)] = changeable[index(Concept::kPositionX)];
      depends[index(Concept::kPositionY)] = changeable[index(Concept::kPositionY)];
    }
  }
  return depends;
}

/// Adds each combination of the concepts' next symbols as a step.
void addSteps(Action action, TargetState from, const std::array<std::size_t, kNumConcepts>& stride,
              const std::array<const ConceptOutcomes*, kNumConcepts>& outcomes,
              const StepRules& rules, std::vector<TargetStep>& steps) {
  std::vector<TargetStep> joint{{action, 0, 1, 0}};
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (stride[k] == 0) continue;
    std::vector<TargetStep> extended;
    for (const TargetStep& step : joint) {
      for (const SymbolOutcome& outcome : outcomes[k]->likeliest) {
        extended.push_back({action,
                            static_cast<TargetState>(step.next + outcome.symbol * stride[k]),
                            step.probability * outcome.probability, 0});
      }
    }
    joint = std::move(extended);
  }
  for (TargetStep& step : joint) {
    if (step.next == from) continue;
    step.cost = rules.cost(step.probability);
    steps.push_back(step);
  }
}

}  // namespace

JointTarget::JointTarget(const SymbolicModel& model, std::span<const Symbols> scene,
                         const std::vector<bool>& moves, std::size_t object, StepRules rules,
                         SearchGuard& guard)
    : model_(model),
      rules_(std::move(rules)),
      start_(scene[object]),
      watched_(scene.size(), false) {
  const ConceptCardinality& cardinality = model.cardinality();
  ConceptSet changeable{};
  for (const Concept which : kConcepts) {
    changeable[index(which)] = model.transitions.changes(which, rules_.frozen_tolerance);
  }
  const bool types_change = changeable[index(Concept::kType)];
  const std::vector<ContextFeature> features = featuresOf(model, changeable);
  std::vector<Symbols> others;
  OpenTypes open(cardinality[index(Concept::kType)], false);
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (i == object) continue;
    others.push_back(scene[i]);
    if (!moves[i]) continue;
    const SymbolId type = scene[i][index(Concept::kType)];
    if (types_change) open.assign(open.size(), true);
    open[index(type)] = true;
    for (const ContextFeature& feature : features) {
      if (feature.kind == ContextKind::kOwnSymbol) continue;
      if (types_change || feature.type == type) watched_[i] = true;
    }
  }

  const auto around = [&](const Symbols& target) {
    return Surroundings{model.grounding, target, others};
  };
  std::array<std::array<SymbolTable<ConceptOutcomes>, kNumConcepts>, kNumActions> outcomes;
  std::array<bool, kNumActions> defined{};
  ConceptSet changes{};
  for (const Action action : kActions) {
    // Where no TYPE symbol changes, what is on the workbench stays there.
    defined[index(action)] =
        types_change || model.transitions.isDefined(action, around(scene[object]));
    for (const Concept which : kConcepts) {
      if (!defined[index(action)] || !changeable[index(which)]) continue;
      auto& table = outcomes[index(action)][index(which)];
      table = SymbolTable<ConceptOutcomes>(
          {dependence(model.transitions.effect(action, which).context, which, changeable, open),
           cardinality},
          start_, [&](const Symbols& target) {
            if (!guard.goesOn()) return ConceptOutcomes{};
            return outcomesOf(model, action, which, around(target), open, rules_.min_share);
          });
      for (const ConceptOutcomes& entry : table.values()) {
        if (entry.change > rules_.frozen_tolerance) changes[index(which)] = true;
      }
    }
  }
  std::size_t num_states = 1;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    frozen_here_[k] = changeable[k] && !changes[k];
    if (!changes[k]) continue;
    stride_[k] = num_states;
    num_states *= cardinality[k];
  }

  possible_.resize(num_states);
  for (TargetState state = 0; state < num_states && guard.goesOn(); ++state) {
    const Symbols target = symbols(state);
    for (const Action action : kActions) {
      if (!defined[index(action)] ||
          legalityOf(model, action, around(target), open) <= rules_.legality_threshold) {
        continue;
      }
      std::array<const ConceptOutcomes*, kNumConcepts> next{};
      for (std::size_t k = 0; k < kNumConcepts; ++k) {
        if (changes[k]) next[k] = &outcomes[index(action)][k][target];
      }
      addSteps(action, state, stride_, next, rules_, possible_[state]);
    }
  }
}

Symbols JointTarget::symbols(TargetState state) const {
  Symbols symbols = start_;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (stride_[k] == 0) continue;
    symbols[k] = static_cast<SymbolId>(state / stride_[k] % model_.cardinality()[k]);
  }
  return symbols;
}

TargetState JointTarget::state(const Symbols& symbols) const {
  std::size_t packed = 0;
  for (std::size_t k = 0; k < kNumConcepts; ++k) packed += index(symbols[k]) * stride_[k];
  return static_cast<TargetState>(packed);
}

double JointTarget::legality(TargetState state, Action action,
                             std::span<const Symbols> others) const {
  const Surroundings surroundings{model_.grounding, symbols(state), others};
  if (!model_.transitions.isDefined(action, surroundings)) return 0;
  return model_.legality.probability(action, surroundings);
}

std::vector<TargetStep> JointTarget::steps(TargetState state,
                                           std::span<const Symbols> others) const {
  const Surroundings surroundings{model_.grounding, symbols(state), others};
  const OpenTypes none(model_.cardinality()[index(Concept::kType)], false);
  std::vector<TargetStep> steps;
  for (const Action action : kActions) {
    if (!isLegal(legality(state, action, others))) continue;
    std::array<ConceptOutcomes, kNumConcepts> outcomes;
    std::array<const ConceptOutcomes*, kNumConcepts> next{};
    for (const Concept which : kConcepts) {
      if (!isPart(which)) continue;
      outcomes[index(which)] =
          outcomesOf(model_, action, which, surroundings, none, rules_.min_share);
      next[index(which)] = &outcomes[index(which)];
    }
    addSteps(action, state, stride_, next, rules_, steps);
  }
  return steps;
}

}  // namespace conceptplan
