#include "fcl_bodies.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace conceptplan {
namespace {

Outline grown(Outline outline, double grown_m) {
  for (double& support_m : outline.support_m) support_m += grown_m;
  return outline;
}

/// The corners of what a convex outline covers on a way, counter-clockwise: of its start where they
/// trail, of its end where they lead, of both where the one turns into the other.
std::vector<Eigen::Vector2d> swept(const std::vector<Eigen::Vector2d>& corners,
                                   const Eigen::Vector2d& way) {
  // Whether the edge from a corner to the next faces along the way.
  const auto leads = [&](std::size_t edge) {
    const Eigen::Vector2d along = corners[(edge + 1) % corners.size()] - corners[edge];
    return along.y() * way.x() - along.x() * way.y() > 0;
  };
  std::vector<Eigen::Vector2d> covered;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool led = leads((i + corners.size() - 1) % corners.size());
    covered.push_back(led ? corners[i] + way : corners[i]);
    if (leads(i) != led) covered.push_back(led ? corners[i] : corners[i] + way);
  }
  return covered;
}

/// What stands on `base`, counter-clockwise, from z = 0 to the height.
std::shared_ptr<const fcl::Convexd> prismOn(const std::vector<Eigen::Vector2d>& base,
                                            double height_m) {
  const auto count = static_cast<int>(base.size());
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const double z_m : {0.0, height_m}) {
    for (const Eigen::Vector2d& corner : base) vertices->emplace_back(corner.x(), corner.y(), z_m);
  }
  // Each face: how many vertices, then which, counter-clockwise seen from outside.
  auto faces = std::make_shared<std::vector<int>>();
  faces->push_back(count);
  for (int i = count; i-- > 0;) faces->push_back(i);
  faces->push_back(count);
  for (int i = 0; i < count; ++i) faces->push_back(count + i);
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    faces->insert(faces->end(), {4, i, next, count + next, count + i});
  }
  return std::make_shared<fcl::Convexd>(vertices, count + 2, faces);
}

}  // namespace

std::shared_ptr<const fcl::Convexd> shapeOf(const Outline& outline, double height_m,
                                            double grown_m) {
  return prismOn(cornersOf(grown(outline, grown_m)), height_m);
}

std::shared_ptr<const fcl::Convexd> sweptShapeOf(const UprightPrism& prism,
                                                 const Eigen::Vector2d& way, double grown_m) {
  return prismOn(swept(cornersOf(grown(prism.outline, grown_m)), way), prism.height_m);
}

fcl::CollisionObjectd boundsOf(const UprightPrism& prism, const Eigen::Vector2d& p_WTo,
                               double grown_m) {
  const OutlineBox box = boxOf(prism.outline);
  const Eigen::Vector2d low = prism.p_WCentre.cwiseMin(p_WTo) + box.low_m;
  const Eigen::Vector2d high = prism.p_WCentre.cwiseMax(p_WTo) + box.high_m;
  const Eigen::Vector2d middle = 0.5 * (low + high);
  const Eigen::Vector2d size = (high - low).array() + 2 * grown_m;
  return {std::make_shared<fcl::Boxd>(size.x(), size.y(), prism.height_m),
          fcl::Matrix3d::Identity(), fcl::Vector3d(middle.x(), middle.y(), 0.5 * prism.height_m)};
}

bool collide(const fcl::Convexd& a, const Eigen::Vector2d& p_WA, const fcl::Convexd& b,
             const Eigen::Vector2d& p_WB) {
  const auto placed = [](const Eigen::Vector2d& p_W) {
    fcl::Transform3d X_W = fcl::Transform3d::Identity();
    X_W.translation().head<2>() = p_W;
    return X_W;
  };
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(&a, placed(p_WA), &b, placed(p_WB), request, result) > 0;
}

}  // namespace conceptplan
