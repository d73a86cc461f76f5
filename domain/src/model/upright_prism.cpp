#include "conceptplan/domain/model/upright_prism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace conceptplan {
namespace {

/// The gap along direction k from `other` to `moved`.
double gapAlong_m(const UprightPrism& moved, const UprightPrism& other, std::size_t k) {
  return outlineDirection(k).dot(moved.p_WCentre - other.p_WCentre) - other.outline.support_m[k] -
         moved.outline.support_m[opposite(k)];
}

}  // namespace

bool UprightPrism::measured() const {
  return p_WCentre.allFinite() && std::isfinite(height_m) && height_m > 0 &&
         std::all_of(outline.support_m.begin(), outline.support_m.end(),
                     [](double support_m) { return std::isfinite(support_m) && support_m > 0; });
}

UprightPrism prismOf(const Workbench& workbench, const SymbolGrounding& grounding,
                     const Symbols& symbols, double max_half_width_cells) {
  const Footprint& footprint = grounding.footprint(symbols);
  return {workbench.p_WCell(grounding.cell(symbols)),
          clipped(footprint.outline, outlineOfSquare(max_half_width_cells * workbench.cell_m)),
          footprint.height_m};
}

double clearance_m(const UprightPrism& a, const UprightPrism& b) {
  double widest_m = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < Outline::kDirections; ++k) {
    widest_m = std::max(widest_m, gapAlong_m(a, b, k));
  }
  return widest_m;
}

double clearanceAlong_m(const UprightPrism& moved, const Eigen::Vector2d& p_WTo,
                        const UprightPrism& other) {
  // The distance is convex in the share of the way: the largest of 16 linear functions. From the
  // start on, each turn goes to the next that overtakes, until it grows or the way ends.
  const Eigen::Vector2d way = p_WTo - moved.p_WCentre;
  std::array<double, Outline::kDirections> gap_m, slope_m;
  std::size_t widest = 0;
  for (std::size_t k = 0; k < Outline::kDirections; ++k) {
    gap_m[k] = gapAlong_m(moved, other, k);
    slope_m[k] = outlineDirection(k).dot(way);
    if (gap_m[k] > gap_m[widest] || (gap_m[k] == gap_m[widest] && slope_m[k] > slope_m[widest])) {
      widest = k;
    }
  }
  double share = 0;
  while (slope_m[widest] < 0 && share < 1) {
    double next_share = 1;
    std::size_t next = widest;
    for (std::size_t k = 0; k < Outline::kDirections; ++k) {
      if (slope_m[k] <= slope_m[widest]) continue;
      const double overtakes = (gap_m[widest] - gap_m[k]) / (slope_m[k] - slope_m[widest]);
      if (overtakes < next_share) {
        next_share = overtakes;
        next = k;
      }
    }
    share = std::max(share, next_share);
    if (next == widest) break;
    widest = next;
  }
  return gap_m[widest] + share * slope_m[widest];
}

double edgeClearance_m(const Workbench& workbench, const UprightPrism& prism) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < Outline::kDirections; k += Outline::kDirections / 4) {
    const Eigen::Vector2d& outwards = outlineDirection(k);
    const double half_m =
        0.5 * workbench.cell_m *
        std::abs(outwards.dot(Eigen::Vector2d(workbench.columns, workbench.rows)));
    nearest_m =
        std::min(nearest_m, half_m - outwards.dot(prism.p_WCentre) - prism.outline.support_m[k]);
  }
  return nearest_m;
}

}  // namespace conceptplan
