#pragma once

#include <Eigen/Core>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/workbench.hpp"

namespace conceptplan {

/// Footprints count up to this share of a cell's edge: what a handle sticks out further passes over
/// its neighbour.
inline constexpr double kMaxRadiusCells = 0.48;

/// The collision geometry of an object: an upright cylinder that stands on the workbench. It is
/// learned too: radius and height are measured from depth pictures for each TYPE and SIZE symbol.
struct UprightCylinder {
  Eigen::Vector2d p_WCentre;
  double radius_m = 0;
  double height_m = 0;

  /// Whether all of it is finite, and radius and height > 0.
  bool measured() const;
};

/// The footprint of the TYPE and SIZE symbols in the middle of the cell of the position symbols.
/// @pre the symbols are below the cardinality of the grounding.
UprightCylinder cylinderOf(const Workbench& workbench, const SymbolGrounding& grounding,
                           const Symbols& symbols, double max_radius_cells = kMaxRadiusCells);

/// Distance of two cylinders on one workbench, which is that of their discs, metres; negative where
/// they overlap.
double clearance_m(const UprightCylinder& a, const UprightCylinder& b);

/// The least distance between them while `moved` goes straight from where it stands to `p_WTo`.
double clearanceAlong_m(const UprightCylinder& moved, const Eigen::Vector2d& p_WTo,
                        const UprightCylinder& other);

/// From the cylinder to the nearest edge of the workbench, metres; negative where it sticks out.
double edgeClearance_m(const Workbench& workbench, const UprightCylinder& cylinder);

}  // namespace conceptplan
