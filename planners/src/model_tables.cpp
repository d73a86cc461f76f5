#include "model_tables.hpp"

#include <algorithm>

namespace conceptplan {
namespace {

using ConceptSet = std::array<bool, kNumConcepts>;

/// Adds what the feature depends on of the target; where a neighbour lies depends on the position.
void addDependence(const ContextFeature& feature, const ConceptSet& changeable,
                   ConceptSet& depends) {
  const auto add = [&](Concept which) { depends[index(which)] = changeable[index(which)]; };
  if (feature.kind == ContextKind::kOwnSymbol) {
    add(feature.which);
  } else {
    add(Concept::kPositionX);
    add(Concept::kPositionY);
  }
}

std::vector<SymbolOutcome> probableOutcomes(const std::vector<double>& next, double min_share) {
  const double least = min_share * *std::max_element(next.begin(), next.end());
  std::vector<SymbolOutcome> outcomes;
  for (std::size_t symbol = 0; symbol < next.size(); ++symbol) {
    if (next[symbol] > 0 && next[symbol] >= least) outcomes.push_back({symbol, next[symbol]});
  }
  return outcomes;
}

}  // namespace

ModelTables::ModelTables(const SymbolicModel& model, const Surroundings& among,
                         const std::array<bool, kNumConcepts>& changeable, double min_share) {
  const auto with = [&](const Symbols& target) {
    return Surroundings{among.grounding, target, among.others};
  };
  for (const Action action : kActions) {
    // Whether an object is absent does not depend on the target.
    is_defined_[index(action)] = model.transitions.isDefined(action, among);
    ConceptSet depends{};
    for (const LegalityFactor& factor : model.legality.factors(action)) {
      addDependence(factor.context, changeable, depends);
    }
    legality_[index(action)] =
        SymbolTable<double>(depends, model.cardinality(), among.target, [&](const Symbols& target) {
          return is_defined_[index(action)] ? model.legality.probability(action, with(target)) : 0;
        });
    for (const Concept which : kConcepts) {
      if (!changeable[index(which)]) continue;
      depends = {};
      depends[index(which)] = true;
      for (const ContextFeature& feature : model.transitions.effect(action, which).context) {
        addDependence(feature, changeable, depends);
      }
      effects_[index(action)][index(which)] = SymbolTable<LocalEffect>(
          depends, model.cardinality(), among.target, [&](const Symbols& target) {
            const std::vector<double> next =
                model.transitions.distribution(action, which, with(target));
            return LocalEffect{probableOutcomes(next, min_share),
                               1 - next[index(target[index(which)])]};
          });
    }
  }
}

bool ModelTables::changes(Concept which, double tolerance) const {
  return std::any_of(kActions.begin(), kActions.end(), [&](Action action) {
    const auto& effects = effects_[index(action)][index(which)].values();
    return is_defined_[index(action)] &&
           std::any_of(effects.begin(), effects.end(),
                       [&](const LocalEffect& effect) { return effect.change > tolerance; });
  });
}

}  // namespace conceptplan
