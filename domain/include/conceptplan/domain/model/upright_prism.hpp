#pragma once

#include <array>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/workbench.hpp"

namespace conceptplan {

/// Footprints count up to this share of a cell's edge from the middle of the cell, along both axes:
/// what a handle or a corner sticks out further passes over its neighbour.
inline constexpr double kMaxHalfWidthCells = 0.48;

/// The collision geometry of an object: a convex prism that stands on the workbench. It is learned
/// too: outline and height are measured from depth pictures for each TYPE, SIZE and ROTATION
/// symbol.
struct UprightPrism {
  Eigen::Vector2d p_WCentre;
  Outline outline;
  double height_m = 0;

  /// Whether all of it is finite, and supports and height > 0.
  bool measured() const;
};

/// The footprint of the symbols in the middle of the cell of the position symbols.
/// @pre the symbols are below the cardinality of the grounding.
UprightPrism prismOf(const Workbench& workbench, const SymbolGrounding& grounding,
                     const Symbols& symbols, double max_half_width_cells = kMaxHalfWidthCells);

/// How far two outlines at their places are apart along each direction, from that of `b` to that of
/// `a`, metres; negative where they overlap along it. [16]
std::array<double, Outline::kDirections> gaps_m(const Outline& a, const Eigen::Vector2d& p_WA,
                                                const Outline& b, const Eigen::Vector2d& p_WB);

/// Distance of two prisms on one workbench, seen from above, metres: the widest gap between them
/// along the 16 directions of outlines, which is Euclid's distance or up to 2 % less. Negative
/// where they overlap.
double clearance_m(const UprightPrism& a, const UprightPrism& b);

/// The least distance between them while `moved` goes straight from where it stands to `p_WTo`.
double clearanceAlong_m(const UprightPrism& moved, const Eigen::Vector2d& p_WTo,
                        const UprightPrism& other);

/// From the prism to the nearest edge of the workbench, metres; negative where it sticks out.
double edgeClearance_m(const Workbench& workbench, const UprightPrism& prism);

}  // namespace conceptplan
