#pragma once

#include <vector>

#include "symbol_index.hpp"

namespace conceptplan {

/// What depends on some of the target's symbols alone, worked out once for each value of these.
template <typename Value>
class SymbolTable {
 public:
  SymbolTable() = default;

  /// @param value of symbols in which those not indexed are the ones of `fixed`.
  template <typename Function>
  SymbolTable(const SymbolIndex& concepts, const Symbols& fixed, Function value)
      : index_(concepts) {
    values_.reserve(concepts.size());
    concepts.forEach(fixed, [&](const Symbols& symbols) { values_.push_back(value(symbols)); });
  }

  const SymbolIndex& index() const { return index_; }
  const Value& operator[](const Symbols& symbols) const { return values_[index_(symbols)]; }
  const std::vector<Value>& values() const { return values_; }

 private:
  SymbolIndex index_;
  std::vector<Value> values_;
};

}  // namespace conceptplan
