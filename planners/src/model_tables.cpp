#include "model_tables.hpp"

#include <algorithm>

namespace conceptplan {
namespace {

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

SymbolEffect effectOf(const std::vector<double>& next, std::size_t own, double min_share) {
  SymbolEffect effect;
  const double least = min_share * *std::max_element(next.begin(), next.end());
  for (std::size_t symbol = 0; symbol < next.size(); ++symbol) {
    if (next[symbol] > 0 && next[symbol] >= least) {
      effect.outcomes.push_back({symbol, next[symbol]});
    }
  }
  effect.change = 1 - next[own];
  effect.stays = effect.outcomes.size() == 1 && next[own] == 1;
  return effect;
}

bool isAboutOthers(const ContextFeature& feature) {
  return feature.kind != ContextKind::kOwnSymbol;
}

}  // namespace

ActionTables::ActionTables(const SymbolicModel& model, Action action, const Surroundings& among,
                           const ConceptSet& changeable, double min_share, SearchGuard& guard)
    // Whether an object is absent does not depend on the target.
    : is_defined(model.transitions.isDefined(action, among)) {
  Surroundings here = among;
  ConceptSet depends{};
  for (const LegalityFactor& factor : model.legality.factors(action)) {
    addDependence(factor.context, changeable, depends);
  }
  legality = {{depends, model.cardinality()}, among.target, [&](const Symbols& target) {
                here.target = target;
                return is_defined && guard.goesOn() ? model.legality.probability(action, here) : 0;
              }};
  for (const Concept which : kConcepts) {
    if (!changeable[index(which)]) continue;
    depends = {};
    depends[index(which)] = true;
    for (const ContextFeature& feature : model.transitions.effect(action, which).context) {
      addDependence(feature, changeable, depends);
    }
    effects[index(which)] = {
        {depends, model.cardinality()}, among.target, [&](const Symbols& target) {
          if (!guard.goesOn()) return SymbolEffect{};
          here.target = target;
          return effectOf(model.transitions.distribution(action, which, here),
                          index(target[index(which)]), min_share);
        }};
  }
}

bool ActionTables::changes(Concept which, double tolerance) const {
  const std::vector<SymbolEffect>& all = effects[index(which)].values();
  return is_defined && std::any_of(all.begin(), all.end(), [&](const SymbolEffect& effect) {
           return effect.change > tolerance;
         });
}

bool dependsOnOthers(const SymbolicModel& model, Action action) {
  const std::vector<LegalityFactor>& factors = model.legality.factors(action);
  return std::any_of(factors.begin(), factors.end(),
                     [](const LegalityFactor& factor) { return isAboutOthers(factor.context); }) ||
         std::any_of(kConcepts.begin(), kConcepts.end(), [&](Concept which) {
           const auto& context = model.transitions.effect(action, which).context;
           return std::any_of(context.begin(), context.end(), isAboutOthers);
         });
}

}  // namespace conceptplan
