#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "conceptplan/learner/transitions/transition_estimation.hpp"

namespace conceptplan {

/// Triplets with the values of all candidate features, column by column.
class StepTable {
 public:
  /// @throws std::invalid_argument if a triplet does not fit the cardinality.
  StepTable(std::span<const Triplet> triplets, const SymbolGrounding& grounding,
            const ConceptCardinality& cardinality);

  const ConceptCardinality& cardinality() const { return cardinality_; }
  std::size_t size() const { return actions_.size(); }
  Action action(std::size_t step) const { return actions_[step]; }
  std::size_t symbolBefore(std::size_t step, Concept which) const {
    return before_[index(which)][step];
  }
  std::size_t symbolAfter(std::size_t step, Concept which) const {
    return after_[index(which)][step];
  }

  /// The value of the feature in each step.
  const std::vector<std::uint16_t>& column(const ContextFeature& feature) const {
    return columns_.at(feature);
  }
  bool isAbsent(const ContextFeature& feature, std::size_t step) const {
    return conceptplan::isAbsent(feature, cardinality_, column(feature)[step]);
  }

 private:
  ConceptCardinality cardinality_;
  std::vector<Action> actions_;
  std::array<std::vector<std::uint16_t>, kNumConcepts> before_;
  std::array<std::vector<std::uint16_t>, kNumConcepts> after_;
  std::map<ContextFeature, std::vector<std::uint16_t>> columns_;
};

/// The target's own symbols, that of `first` in front.
std::vector<ContextFeature> ownSymbolFeatures(Concept first);

/// One feature of the kind for each TYPE symbol.
std::vector<ContextFeature> nearestFeatures(ContextKind kind, Concept which,
                                            const ConceptCardinality& cardinality);

}  // namespace conceptplan
