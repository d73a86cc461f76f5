#include "conceptplan/fcl/fcl_validity.hpp"

#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

/// What an object takes up: an upright cylinder in the middle of its cell.
struct Body {
  Eigen::Vector2d p_WCentre;
  double radius_m;
  double height_m;

  bool measured() const {
    return std::isfinite(radius_m) && radius_m > 0 && std::isfinite(height_m) && height_m > 0;
  }
};

/// @param grown_m is added to the radius.
fcl::CollisionObjectd standing(const Body& body, double grown_m) {
  return {std::make_shared<fcl::Cylinderd>(body.radius_m + grown_m, body.height_m),
          fcl::Matrix3d::Identity(),
          fcl::Vector3d(body.p_WCentre.x(), body.p_WCentre.y(), 0.5 * body.height_m)};
}

bool meet(const Body& a, const Body& b, double margin_m) {
  const fcl::CollisionObjectd grown = standing(a, margin_m);
  const fcl::CollisionObjectd other = standing(b, 0);
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(&grown, &other, request, result) > 0;
}

/// Both stand on the workbench, so their distance is that of their discs; negative where they meet.
double clearance_m(const Body& a, const Body& b) {
  return (a.p_WCentre - b.p_WCentre).norm() - a.radius_m - b.radius_m;
}

/// From a disc to the nearest edge of the workbench, metres; negative where it sticks out.
double edgeClearance_m(const Workbench& workbench, const Body& body) {
  const Eigen::Array2d half_m =
      0.5 * workbench.cell_m * Eigen::Array2d(workbench.columns, workbench.rows);
  return (half_m - body.p_WCentre.array().abs()).minCoeff() - body.radius_m;
}

}  // namespace

FclValidity::FclValidity(const FclValidityOptions& options) : options_(options) {
  if (!(options.margin_m > 0)) {
    throw std::invalid_argument("margin_m is " + std::to_string(options.margin_m) +
                                ", expected > 0");
  }
  if (!(options.max_radius_cells > 0 && options.max_radius_cells < 0.5)) {
    throw std::invalid_argument("max_radius_cells is " + std::to_string(options.max_radius_cells) +
                                ", expected a number in (0, 0.5)");
  }
}

Verdict FclValidity::check(const Workbench& workbench, const SymbolGrounding& grounding,
                           const Symbols& target, std::span<const Symbols> others) const {
  const double widest_m = options_.max_radius_cells * workbench.cell_m;
  const auto bodyOf = [&](const Symbols& symbols) {
    const Footprint& footprint = grounding.footprint(symbols);
    return Body{workbench.p_WCell(grounding.cell(symbols)), std::min(footprint.radius_m, widest_m),
                footprint.height_m};
  };
  const Body own = bodyOf(target);
  if (!own.measured()) return {Invalidity::kCheckFailed, 0, 0};
  Verdict nearest{Invalidity::kNone, 0, edgeClearance_m(workbench, own)};
  if (nearest.clearance_m < 0) return {Invalidity::kWorkbenchEdge, 0, nearest.clearance_m};
  try {
    for (std::size_t i = 0; i < others.size(); ++i) {
      const Body other = bodyOf(others[i]);
      if (!other.measured()) return {Invalidity::kCheckFailed, i, 0};
      const double distance_m = clearance_m(own, other);
      if (meet(own, other, options_.margin_m)) return {Invalidity::kCollision, i, distance_m};
      nearest.clearance_m = std::min(nearest.clearance_m, distance_m);
    }
  } catch (const std::exception&) {
    return {Invalidity::kCheckFailed, 0, 0};
  }
  return nearest;
}

std::array<bool, kNumConcepts> FclValidity::dependsOn() const {
  std::array<bool, kNumConcepts> concepts{};
  for (const Concept which :
       {Concept::kType, Concept::kPositionX, Concept::kPositionY, Concept::kSize}) {
    concepts[index(which)] = true;
  }
  return concepts;
}

}  // namespace conceptplan
