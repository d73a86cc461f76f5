#pragma once

#include <array>
#include <map>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/model/context_feature.hpp"

namespace conceptplan {

/// How often each outcome was seen in each context: raw, accumulating.
struct ContextCounts {
  std::vector<ContextFeature> context;
  std::map<std::size_t, std::vector<double>> rows;  ///< joint value -> count of each outcome

  /// Counts one step. @pre outcome < outcomes
  void add(std::size_t joint_value, std::size_t outcome, std::size_t outcomes);

  bool operator==(const ContextCounts&) const = default;
};

/// The effect of one action on one concept: Pr[next symbol | context].
struct Effect {
  std::vector<ContextFeature> context;
  std::map<std::size_t, std::vector<double>> rows;  ///< joint value -> distribution over symbols
  /// For contexts without a row: the probability that the symbol stays; the rest is spread evenly
  /// over the other symbols.
  double stays = 1;

  bool operator==(const Effect&) const = default;
};

using EffectTable = std::array<std::array<Effect, kNumConcepts>, kNumActions>;

/// Pr[Omega' | a, Omega], one factor a concept: the effects of the actions. Immutable, so threads
/// may share it. Source: Eq. (4), eq:mdpsigma1, of arXiv 2310.03325; the context of other objects'
/// symbols is ours, because a dyer's colour reaches the target through it.
class TransitionModel {
 public:
  /// @throws std::invalid_argument if a row is not a distribution over the concept's symbols or
  /// its joint value is out of range.
  TransitionModel(const ConceptCardinality& cardinality, EffectTable effects);

  const ConceptCardinality& cardinality() const { return cardinality_; }
  const Effect& effect(Action action, Concept which) const {
    return effects_[index(action)][index(which)];
  }

  /// The distribution of the next symbol, [cardinality of the concept].
  std::vector<double> distribution(Action action, Concept which,
                                   const Surroundings& surroundings) const;
  /// The same for a joint value of the effect's context and the target's own symbol.
  std::vector<double> distribution(Action action, Concept which, std::size_t joint_value,
                                   SymbolId own) const;

  /// False where the action takes a symbol from an object that is not on the workbench: then it
  /// has no effect that was ever seen, and it is not legal.
  bool isDefined(Action action, const Surroundings& surroundings) const;

  /// Whether any action changes the concept with more than that probability in any context seen.
  bool changes(Concept which, double tolerance) const {
    return greatest_change_[index(which)] > tolerance;
  }

  bool operator==(const TransitionModel&) const = default;

 private:
  ConceptCardinality cardinality_;
  EffectTable effects_;
  std::array<double, kNumConcepts> greatest_change_{};
};

}  // namespace conceptplan
