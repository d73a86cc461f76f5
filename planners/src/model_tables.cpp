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

/// Whether any of all that the legality of the action and its effects depend on is wanted.
template <typename Predicate>
bool anyFeature(const SymbolicModel& model, Action action, Predicate is_wanted) {
  const std::vector<LegalityFactor>& factors = model.legality.factors(action);
  return std::any_of(factors.begin(), factors.end(),
                     [&](const LegalityFactor& factor) { return is_wanted(factor.context); }) ||
         std::any_of(kConcepts.begin(), kConcepts.end(), [&](Concept which) {
           const auto& context = model.transitions.effect(action, which).context;
           return std::any_of(context.begin(), context.end(), is_wanted);
         });
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
  return anyFeature(model, action, isAboutOthers);
}

std::vector<bool> watchedTypes(const SymbolicModel& model) {
  const std::size_t count = model.cardinality()[index(Concept::kType)];
  std::vector<bool> types(count, false);
  for (std::size_t type = 0; type < count; ++type) {
    types[type] = std::any_of(kActions.begin(), kActions.end(), [&](Action action) {
      return anyFeature(model, action, [&](const ContextFeature& feature) {
        return isAboutOthers(feature) && index(feature.type) == type;
      });
    });
  }
  return types;
}

}  // namespace conceptplan
