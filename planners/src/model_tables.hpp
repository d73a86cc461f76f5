#pragma once

#include <array>
#include <functional>
#include <vector>

#include "conceptplan/domain/model/symbolic_model.hpp"

namespace conceptplan {

/// What depends on some of the target's symbols alone, worked out once for each value of these.
template <typename Value>
class SymbolTable {
 public:
  SymbolTable() = default;

  /// @param depends the concepts that matter; the others keep their symbols of `fixed`.
  SymbolTable(const std::array<bool, kNumConcepts>& depends, const ConceptCardinality& cardinality,
              const Symbols& fixed, const std::function<Value(const Symbols&)>& value) {
    std::size_t size = 1;
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      if (!depends[k]) continue;
      stride_[k] = size;
      size *= cardinality[k];
    }
    values_.reserve(size);
    Symbols symbols = fixed;
    for (std::size_t entry = 0; entry < size; ++entry) {
      for (std::size_t k = 0; k < kNumConcepts; ++k) {
        if (depends[k]) symbols[k] = static_cast<SymbolId>(entry / stride_[k] % cardinality[k]);
      }
      values_.push_back(value(symbols));
    }
  }

  const Value& operator[](const Symbols& symbols) const {
    std::size_t entry = 0;
    for (std::size_t k = 0; k < kNumConcepts; ++k) entry += index(symbols[k]) * stride_[k];
    return values_[entry];
  }

  const std::vector<Value>& values() const { return values_; }

 private:
  std::array<std::size_t, kNumConcepts> stride_{};  // 0 for concepts that do not matter
  std::vector<Value> values_;
};

/// One possible next symbol of a concept.
struct SymbolOutcome {
  std::size_t symbol;
  double probability;
};

/// A symbolic model among certain other objects, as tables over the target's symbols.
class ModelTables {
 public:
  /// @param among the other objects, and the target's symbols of the concepts that stay.
  /// @param changeable the concepts whose symbol may be another one than in `among`.
  /// @param min_share outcomes with a smaller share of the most probable one are left out.
  ModelTables(const SymbolicModel& model, const Surroundings& among,
              const std::array<bool, kNumConcepts>& changeable, double min_share);

  /// Pr[a | Omega]; 0 where the action has no effect that is defined.
  double legality(Action action, const Symbols& target) const {
    return legality_[index(action)][target];
  }

  /// The next symbols of a concept, by symbol.
  const std::vector<SymbolOutcome>& outcomes(Action action, Concept which,
                                             const Symbols& target) const {
    return effects_[index(action)][index(which)][target].outcomes;
  }

  /// Whether some action among these objects changes the concept with more than that probability.
  bool changes(Concept which, double tolerance) const;

 private:
  struct LocalEffect {
    std::vector<SymbolOutcome> outcomes;
    double change = 0;  ///< Pr[the symbol does not stay]
  };

  std::array<bool, kNumActions> is_defined_{};
  std::array<SymbolTable<double>, kNumActions> legality_;
  std::array<std::array<SymbolTable<LocalEffect>, kNumConcepts>, kNumActions> effects_;
};

}  // namespace conceptplan
