#include "conceptplan/fcl/fcl_validity.hpp"

#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

/// An upright cylinder that stands in the middle of its cell.
fcl::CollisionObjectd standing(const Workbench& workbench, Cell cell, double radius_m,
                               double height_m) {
  const Eigen::Vector2d p_WCell = workbench.p_WCell(cell);
  return {std::make_shared<fcl::Cylinderd>(radius_m, height_m), fcl::Matrix3d::Identity(),
          fcl::Vector3d(p_WCell.x(), p_WCell.y(), 0.5 * height_m)};
}

/// Distance between two objects, metres; 0 where they meet.
double distance_m(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  const fcl::DistanceRequestd request(false);
  fcl::DistanceResultd result;
  fcl::distance(&a, &b, request, result);
  return std::max(0.0, result.min_distance);
}

/// From a disc to the nearest edge of the workbench, metres; negative where it sticks out.
double edgeClearance_m(const Workbench& workbench, Cell cell, double radius_m) {
  const Eigen::Array2d p_WCell = workbench.p_WCell(cell).array().abs();
  const Eigen::Array2d half_m =
      0.5 * workbench.cell_m * Eigen::Array2d(workbench.columns, workbench.rows);
  return (half_m - p_WCell).minCoeff() - radius_m;
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
  const auto radius_m = [&](const Symbols& symbols) {
    return std::min(widest_m, grounding.footprint(symbols).radius_m);
  };
  const auto body = [&](const Symbols& symbols) {
    return standing(workbench, grounding.cell(symbols), radius_m(symbols),
                    grounding.footprint(symbols).height_m);
  };
  const double edge_m = edgeClearance_m(workbench, grounding.cell(target), radius_m(target));
  if (edge_m < 0) return {Invalidity::kWorkbenchEdge, 0, edge_m};
  try {
    const fcl::CollisionObjectd own = body(target);
    Verdict nearest{Invalidity::kNone, 0, edge_m};
    for (std::size_t i = 0; i < others.size(); ++i) {
      const double clearance_m = distance_m(own, body(others[i]));
      if (clearance_m < options_.margin_m) return {Invalidity::kCollision, i, clearance_m};
      nearest.clearance_m = std::min(nearest.clearance_m, clearance_m);
    }
    return nearest;
  } catch (const std::exception&) {
    return {Invalidity::kCheckFailed, 0, 0};
  }
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
