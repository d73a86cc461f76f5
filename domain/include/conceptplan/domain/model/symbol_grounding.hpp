#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "conceptplan/domain/concept.hpp"
#include "conceptplan/domain/model/outline.hpp"
#include "conceptplan/domain/object.hpp"
#include "conceptplan/domain/symbols.hpp"

namespace conceptplan {

/// Number of symbols of each concept.
using ConceptCardinality = std::array<std::size_t, kNumConcepts>;

/// The convex prism around an object, measured from depth pictures.
struct Footprint {
  Outline outline;      ///< about the middle of the object's cell; supports > 0, tight
  double height_m = 0;  ///< > 0
  bool operator==(const Footprint&) const = default;
};

/// [TYPE symbol][SIZE symbol][ROTATION symbol]
using FootprintTable = std::vector<std::vector<std::vector<Footprint>>>;

/// The same footprint for all of them.
FootprintTable uniformFootprints(const ConceptCardinality& cardinality, const Footprint& footprint);

/// What symbols stand for in space. Given by the geometry of the workbench and measured from depth,
/// without labels.
struct SymbolGrounding {
  std::vector<int> columns;  ///< of each POSITION_X symbol; column of `Cell`, >= 0
  std::vector<int> rows;     ///< of each POSITION_Y symbol; row of `Cell`, >= 0
  FootprintTable footprints;
  /// A person's names of the symbols, for display; no planner reads them. Empty where unnamed.
  std::array<std::vector<std::string>, kNumConcepts> names;

  /// The cell that the position symbols stand for. @pre the symbols are below their cardinality
  Cell cell(const Symbols& symbols) const;

  /// The footprint of the TYPE, SIZE and ROTATION symbols. @pre they are below their cardinality
  const Footprint& footprint(const Symbols& symbols) const;

  /// The name of the symbol, or "COLOR 3" where it has none.
  std::string name(Concept which, SymbolId symbol) const;

  /// What is wrong with this grounding for that many symbols, one sentence each; empty if nothing.
  std::vector<std::string> faults(const ConceptCardinality& cardinality) const;

  bool operator==(const SymbolGrounding&) const = default;
};

/// The grounding in which the symbol of each value is the value's own number, names included, for
/// a workbench of 3 x 5 cells: for programs that write symbols by hand, and for tests.
SymbolGrounding standardGrounding();

}  // namespace conceptplan
