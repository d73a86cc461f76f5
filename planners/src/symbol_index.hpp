#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "conceptplan/domain/model/symbol_grounding.hpp"

namespace conceptplan {

/// Some of the concepts.
using ConceptSet = std::array<bool, kNumConcepts>;

/// Numbers the combinations of the symbols of some concepts, the first concept running fastest.
class SymbolIndex {
 public:
  SymbolIndex() = default;

  SymbolIndex(const ConceptSet& concepts, const ConceptCardinality& cardinality) {
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      const auto symbols = static_cast<std::uint32_t>(cardinality[k]);
      if (!concepts[k] || symbols == 1) continue;  // the only symbol is 0 in every combination
      axes_[count_++] = {static_cast<std::uint32_t>(k), symbols, static_cast<std::uint32_t>(size_),
                         std::numeric_limits<std::uint64_t>::max() / symbols + 1};
      size_ *= symbols;
    }
  }

  bool operator==(const SymbolIndex&) const = default;

  std::size_t size() const { return size_; }

  bool has(std::size_t concept_number) const { return axisOf(concept_number) != nullptr; }

  /// By how much the number grows from one symbol of the concept to the next; 0 if not indexed.
  std::size_t stride(std::size_t concept_number) const {
    const Axis* axis = axisOf(concept_number);
    return axis == nullptr ? 0 : axis->stride;
  }

  /// The number of the symbols; concepts that are not indexed are not read.
  std::size_t operator()(const Symbols& symbols) const {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      number += static_cast<std::uint32_t>(symbols[axes_[i].which]) * axes_[i].stride;
    }
    return number;
  }

  /// The symbols of the number; concepts that are not indexed keep those of `fixed`.
  Symbols symbols(std::size_t number, const Symbols& fixed) const {
    Symbols symbols = fixed;
    std::size_t i = 0;
    forEachSymbol(number, [&](std::uint32_t symbol, std::uint32_t) {
      symbols[axes_[i++].which] = static_cast<SymbolId>(symbol);
    });
    return symbols;
  }

  /// Calls `visit` with each symbol of the number, and how many the concept has.
  template <typename Visitor>
  void forEachSymbol(std::size_t number, Visitor visit) const {
    auto rest = static_cast<std::uint32_t>(number);
    for (std::size_t i = 0; i < count_; ++i) {
      const std::uint32_t above = i + 1 == count_ ? 0 : axes_[i].quotient(rest);
      visit(rest - above * axes_[i].cardinality, axes_[i].cardinality);
      rest = above;
    }
  }

  /// The first combination that is wanted, in the order of the numbers; nothing if none is.
  template <typename Predicate>
  std::optional<Symbols> find(const Symbols& fixed, Predicate is_wanted) const {
    Symbols symbols = fixed;
    for (std::size_t i = 0; i < count_; ++i) symbols[axes_[i].which] = SymbolId{0};
    for (std::size_t number = 0; number < size_; ++number) {
      if (is_wanted(std::as_const(symbols))) return symbols;
      advance(symbols);
    }
    return std::nullopt;
  }

  /// Visits all combinations in the order of their numbers.
  template <typename Visitor>
  void forEach(const Symbols& fixed, Visitor visit) const {
    find(fixed, [&](const Symbols& symbols) {
      visit(symbols);
      return false;
    });
  }

 private:
  struct Axis {
    bool operator==(const Axis&) const = default;

    std::uint32_t which;
    std::uint32_t cardinality;
    std::uint32_t stride;
    std::uint64_t inverse;  ///< 2^64 / cardinality, rounded up

    /// number / cardinality without a division.
    /// Source: D. Lemire, O. Kaser and N. Kurz, 2019, doi:10.1002/spe.2689.
    std::uint32_t quotient(std::uint32_t number) const {
      __extension__ using Product = unsigned __int128;
      return static_cast<std::uint32_t>(static_cast<Product>(inverse) * number >> 64);
    }
  };

  const Axis* axisOf(std::size_t concept_number) const {
    for (std::size_t i = 0; i < count_; ++i) {
      if (axes_[i].which == concept_number) return &axes_[i];
    }
    return nullptr;
  }

  void advance(Symbols& symbols) const {
    for (std::size_t i = 0; i < count_; ++i) {
      SymbolId& symbol = symbols[axes_[i].which];
      symbol = static_cast<SymbolId>(static_cast<std::uint32_t>(symbol) + 1);
      if (static_cast<std::uint32_t>(symbol) < axes_[i].cardinality) return;
      symbol = SymbolId{0};
    }
  }

  std::array<Axis, kNumConcepts> axes_{};
  std::size_t count_ = 0;
  std::size_t size_ = 1;
};

}  // namespace conceptplan
