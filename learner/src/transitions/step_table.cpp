#include "step_table.hpp"

#include <limits>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

void checkSymbols(const Symbols& symbols, const ConceptCardinality& cardinality, std::size_t step) {
  for (const Concept which : kConcepts) {
    if (index(symbols[index(which)]) >= cardinality[index(which)]) {
      throw std::invalid_argument("triplet " + std::to_string(step) + ": " +
                                  std::string(name(which)) + " symbol " +
                                  std::to_string(index(symbols[index(which)])) + " is not below " +
                                  std::to_string(cardinality[index(which)]));
    }
  }
}

void checkTriplet(const Triplet& triplet, const ConceptCardinality& cardinality, std::size_t step) {
  if (triplet.target >= triplet.objects.size()) {
    throw std::invalid_argument("triplet " + std::to_string(step) + ": the target is object " +
                                std::to_string(triplet.target) + " of " +
                                std::to_string(triplet.objects.size()));
  }
  for (const Symbols& symbols : triplet.objects) checkSymbols(symbols, cardinality, step);
  checkSymbols(triplet.after, cardinality, step);
}

}  // namespace

StepTable::StepTable(std::span<const Triplet> triplets, const SymbolGrounding& grounding,
                     const ConceptCardinality& cardinality)
    : cardinality_(cardinality) {
  std::vector<ContextFeature> features = ownSymbolFeatures(Concept::kType);
  const auto append = [&](const std::vector<ContextFeature>& more) {
    features.insert(features.end(), more.begin(), more.end());
  };
  append(nearestFeatures(ContextKind::kNearestOffset, Concept::kType, cardinality));
  for (const Concept which : kConcepts) {
    append(nearestFeatures(ContextKind::kNearestSymbol, which, cardinality));
  }
  for (std::size_t step = 0; step < triplets.size(); ++step) {
    const Triplet& triplet = triplets[step];
    checkTriplet(triplet, cardinality, step);
    actions_.push_back(triplet.action);
    std::vector<Symbols> others = triplet.objects;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(triplet.target));
    const Symbols& before = triplet.objects[triplet.target];
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      before_[k].push_back(static_cast<std::uint16_t>(index(before[k])));
      after_[k].push_back(static_cast<std::uint16_t>(index(triplet.after[k])));
    }
    const Surroundings surroundings{grounding, before, others};
    for (const ContextFeature& feature : features) {
      columns_[feature].push_back(
          static_cast<std::uint16_t>(valueOf(feature, cardinality, surroundings)));
    }
  }
}

std::vector<ContextFeature> ownSymbolFeatures(Concept first) {
  std::vector<ContextFeature> features{{ContextKind::kOwnSymbol, first, SymbolId{0}}};
  for (const Concept which : kConcepts) {
    if (which != first) features.push_back({ContextKind::kOwnSymbol, which, SymbolId{0}});
  }
  return features;
}

std::vector<ContextFeature> nearestFeatures(ContextKind kind, Concept which,
                                            const ConceptCardinality& cardinality) {
  std::vector<ContextFeature> features;
  for (std::size_t type = 0; type < cardinality[index(Concept::kType)]; ++type) {
    features.push_back({kind, which, static_cast<SymbolId>(type)});
  }
  return features;
}

}  // namespace conceptplan
