#include "conceptplan/domain/model/upright_prism.hpp"

#include <algorithm>
#include <cmath>

namespace conceptplan {

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

std::array<double, Outline::kDirections> gaps_m(const Outline& a, const Eigen::Vector2d& p_WA,
                                                const Outline& b, const Eigen::Vector2d& p_WB) {
  std::array<double, Outline::kDirections> gaps;
  const Eigen::Vector2d p_BA_W = p_WA - p_WB;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    gaps[k] = outlineDirection(k).dot(p_BA_W) - b.support_m[k] - a.support_m[opposite(k)];
  }
  return gaps;
}

double clearance_m(const UprightPrism& a, const UprightPrism& b) {
  return std::ranges::max(gaps_m(a.outline, a.p_WCentre, b.outline, b.p_WCentre));
}

double clearanceAlong_m(const UprightPrism& moved, const Eigen::Vector2d& p_WTo,
                        const UprightPrism& other) {
  // The distance is convex in the share of the way: the largest of 16 linear functions. From the
  // start on, each turn goes to the next that overtakes, until it grows or the way ends.
  const Eigen::Vector2d way = p_WTo - moved.p_WCentre;
  const auto gap_m = gaps_m(moved.outline, moved.p_WCentre, other.outline, other.p_WCentre);
  std::array<double, Outline::kDirections> slope_m;
  std::size_t widest = 0;
  for (std::size_t k = 0; k < Outline::kDirections; ++k) {
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
  const OutlineBox box = boxOf(prism.outline);
  const Eigen::Vector2d half_m =
      0.5 * workbench.cell_m * Eigen::Vector2d(workbench.columns, workbench.rows);
  return std::min((half_m - prism.p_WCentre - box.high_m).minCoeff(),
                  (half_m + prism.p_WCentre + box.low_m).minCoeff());
}

}  // namespace conceptplan
