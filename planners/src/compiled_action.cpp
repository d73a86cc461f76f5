#include "compiled_action.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace conceptplan {
namespace {

/// The concepts of both that are part of the states.
ConceptSet joined(const ConceptSet& concepts, const SymbolIndex& more, const SymbolIndex& states) {
  ConceptSet all{};
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    all[k] = (concepts[k] || more.has(k)) && states.has(k);
  }
  return all;
}

/// Products of the outcomes of single concepts.
class JointOutcomes {
 public:
  /// Each outcome so far with each one of another concept.
  void extend(const std::vector<SymbolOutcome>& outcomes, SymbolId own, std::size_t stride) {
    extended_.clear();
    for (const Outcome& outcome : joint_) {
      for (const SymbolOutcome& next : outcomes) {
        const auto symbols = static_cast<std::int64_t>(next.symbol) - static_cast<int>(own);
        const auto shift = static_cast<std::int32_t>(symbols * static_cast<std::int64_t>(stride));
        extended_.push_back({outcome.shift + shift, outcome.probability * next.probability, 0});
      }
    }
    std::swap(joint_, extended_);
  }

  /// Scaled to one, by falling probability, ties by state.
  const std::vector<Outcome>& ranked() {
    double sum = 0;
    for (const Outcome& outcome : joint_) sum += outcome.probability;
    for (Outcome& outcome : joint_) {
      outcome.probability /= sum;
      outcome.cost = -std::log(outcome.probability);
    }
    std::sort(joint_.begin(), joint_.end(), [](const Outcome& a, const Outcome& b) {
      return a.probability != b.probability ? a.probability > b.probability : a.shift < b.shift;
    });
    return joint_;
  }

  void reset() { joint_.assign(1, {0, 1, 0}); }

 private:
  std::vector<Outcome> joint_;
  std::vector<Outcome> extended_;
};

}  // namespace

CompiledAction::CompiledAction(const ActionTables& tables, const SymbolIndex& states,
                               const ConceptCardinality& cardinality, const Symbols& fixed,
                               SearchGuard& guard) {
  std::vector<std::size_t> changed;  // concepts
  ConceptSet depends{};
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    const std::vector<SymbolEffect>& effects = tables.effects[k].values();
    const auto stays = [](const SymbolEffect& effect) { return effect.stays; };
    if (!states.has(k) || std::all_of(effects.begin(), effects.end(), stays)) continue;
    changed.push_back(k);
    depends = joined(depends, tables.effects[k].index(), states);
  }
  JointOutcomes joint;
  ranges_ = {{depends, cardinality}, fixed, [&](const Symbols& target) {
               if (!guard.goesOn()) return Range{0, 0};
               joint.reset();
               for (const std::size_t k : changed) {
                 joint.extend(tables.effects[k][target].outcomes, target[k], states.stride(k));
               }
               const std::vector<Outcome>& ranked = joint.ranked();
               const Range range{static_cast<std::uint32_t>(outcomes_.size()),
                                 static_cast<std::uint32_t>(ranked.size())};
               outcomes_.insert(outcomes_.end(), ranked.begin(), ranked.end());
               return range;
             }};
  legality_ = {{joined({}, tables.legality.index(), states), cardinality},
               fixed,
               [&](const Symbols& target) { return tables.legality[target]; }};
  contexts_ = {joined(depends, tables.legality.index(), states), cardinality};
}

}  // namespace conceptplan
