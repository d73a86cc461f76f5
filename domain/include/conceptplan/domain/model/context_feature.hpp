#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conceptplan/domain/model/symbol_grounding.hpp"

namespace conceptplan {

/// What an action meets: the target and all other objects of the workbench, as symbols.
struct Surroundings {
  const SymbolGrounding& grounding;
  Symbols target;
  std::span<const Symbols> others;
};

enum class ContextKind {
  kOwnSymbol,      ///< the target's symbol of a concept
  kNearestSymbol,  ///< the symbol of a concept of the nearest object of a TYPE symbol
  kNearestOffset   ///< columns and rows from the target to the nearest object of a TYPE symbol
};

/// One discrete quantity on which an effect or the legality of an action may depend. Which
/// quantities matter is learned from data.
struct ContextFeature {
  ContextKind kind = ContextKind::kOwnSymbol;
  Concept which = Concept::kType;  ///< not read by kNearestOffset
  SymbolId type{0};                ///< not read by kOwnSymbol

  auto operator<=>(const ContextFeature&) const = default;
};

/// Offsets are clipped to this many cells along each axis.
inline constexpr int kOffsetReach = 2;

/// Which of `surroundings.others` is nearest to the target among those of a TYPE symbol; nothing if
/// there is none. Nearest as for `valueOf`.
std::optional<std::size_t> nearestObject(SymbolId type, const Surroundings& surroundings);

/// The number of values of the feature, the value for "no such object" included.
std::size_t valueCount(const ContextFeature& feature, const ConceptCardinality& cardinality);

/// The value of the feature, below `valueCount`. An absent object gives the last value. Nearest is
/// by Manhattan distance in cells; ties go to the smaller row offset, then column offset.
std::size_t valueOf(const ContextFeature& feature, const ConceptCardinality& cardinality,
                    const Surroundings& surroundings);

/// Whether the value says that the object of the feature is absent; false for kOwnSymbol.
bool isAbsent(const ContextFeature& feature, const ConceptCardinality& cardinality,
              std::size_t value);

/// The value of several features together, the last one running fastest; 0 for none.
std::size_t jointValueOf(std::span<const ContextFeature> features,
                         const ConceptCardinality& cardinality, const Surroundings& surroundings);

/// The values of the single features of a joint value, in the order of the features.
std::vector<std::size_t> splitJointValue(std::span<const ContextFeature> features,
                                         const ConceptCardinality& cardinality, std::size_t joint);

/// In words, e.g. "own POSITION_X" or "offset to the nearest Dyer".
std::string describe(const ContextFeature& feature, const SymbolGrounding& grounding);

}  // namespace conceptplan
