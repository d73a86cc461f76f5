#include "conceptplan/domain/model/upright_cylinder.hpp"

#include <algorithm>
#include <cmath>

namespace conceptplan {

bool UprightCylinder::measured() const {
  return p_WCentre.allFinite() && std::isfinite(radius_m) && radius_m > 0 &&
         std::isfinite(height_m) && height_m > 0;
}

UprightCylinder cylinderOf(const Workbench& workbench, const SymbolGrounding& grounding,
                           const Symbols& symbols, double max_radius_cells) {
  const Footprint& footprint = grounding.footprint(symbols);
  return {workbench.p_WCell(grounding.cell(symbols)),
          std::min(footprint.radius_m, max_radius_cells * workbench.cell_m), footprint.height_m};
}

double clearance_m(const UprightCylinder& a, const UprightCylinder& b) {
  return (a.p_WCentre - b.p_WCentre).norm() - a.radius_m - b.radius_m;
}

double clearanceAlong_m(const UprightCylinder& moved, const Eigen::Vector2d& p_WTo,
                        const UprightCylinder& other) {
  const Eigen::Vector2d way = p_WTo - moved.p_WCentre;
  const Eigen::Vector2d to_other = other.p_WCentre - moved.p_WCentre;
  const double length_squared = way.squaredNorm();
  const double share =
      length_squared > 0 ? std::clamp(to_other.dot(way) / length_squared, 0.0, 1.0) : 0;
  return (to_other - share * way).norm() - moved.radius_m - other.radius_m;
}

double edgeClearance_m(const Workbench& workbench, const UprightCylinder& cylinder) {
  const Eigen::Array2d half_m =
      0.5 * workbench.cell_m * Eigen::Array2d(workbench.columns, workbench.rows);
  return (half_m - cylinder.p_WCentre.array().abs()).minCoeff() - cylinder.radius_m;
}

}  // namespace conceptplan
