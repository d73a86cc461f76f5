#include "conceptplan/fcl/fcl_scene.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "conceptplan/fcl/prism_contact.hpp"
#include "prism_shapes.hpp"

namespace conceptplan {

namespace {

/// What `clearanceAlong_m` tells of Euclid's distance, at least.
constexpr double kLeastShare = 0.98;

/// No point of the prism is further from its place: the lines of two neighbouring directions meet
/// within that.
double reachOf_m(const UprightPrism& prism) {
  return std::ranges::max(prism.outline.support_m) / kLeastShare;
}

double distanceToWay_m(const Eigen::Vector2d& p_W, const Eigen::Vector2d& p_WFrom,
                       const Eigen::Vector2d& p_WTo) {
  const Eigen::Vector2d way = p_WTo - p_WFrom;
  const double squared = way.squaredNorm();
  const double share = squared > 0 ? std::clamp((p_W - p_WFrom).dot(way) / squared, 0.0, 1.0) : 0;
  return (p_W - p_WFrom - share * way).norm();
}

}  // namespace

struct FclScene::Parts {
  Parts(const Workbench& bench, std::vector<UprightPrism> prisms, double margin,
        std::shared_ptr<PrismShapes> known_shapes)
      : workbench(bench),
        others(std::move(prisms)),
        margin_m(margin),
        shapes(std::move(known_shapes)) {
    const auto unmeasured = std::find_if_not(
        others.begin(), others.end(), [](const UprightPrism& body) { return body.measured(); });
    first_unmeasured = static_cast<std::size_t>(unmeasured - others.begin());
    if (first_unmeasured < others.size()) return;  // every check fails
    std::vector<fcl::CollisionObjectd*> registered;
    bounds.reserve(others.size());
    for (UprightPrism& other : others) {
      bounds.push_back(boundsOf(other, other.p_WCentre, 0));
      bounds.back().setUserData(&other);
      reaches_m.push_back(reachOf_m(other));
      registered.push_back(&bounds.back());
    }
    tree.registerObjects(registered);
    tree.setup();
  }
  Parts(const Parts&) = delete;  // the tree points into the bounds
  Parts& operator=(const Parts&) = delete;

  std::shared_ptr<const fcl::Convexd> shapeOnWay(const UprightPrism& prism,
                                                 const Eigen::Vector2d& p_WTo) const {
    const Eigen::Vector2d way = p_WTo - prism.p_WCentre;
    return way.isZero(0) ? shapes->find(prism.outline, prism.height_m, margin_m)
                         : sweptShapeOf(prism, way, margin_m);
  }

  /// Which of the others the prism meets on its way. @throws whatever FCL throws.
  std::vector<bool> met(const UprightPrism& prism, const Eigen::Vector2d& p_WTo) const {
    struct Query {
      const Parts& parts;
      const UprightPrism& prism;
      const Eigen::Vector2d& p_WTo;
      std::vector<bool> met;
      std::shared_ptr<const fcl::Convexd> shape;  // made where a box is met
    } query{*this, prism, p_WTo, std::vector<bool>(others.size(), false), nullptr};
    fcl::CollisionObjectd asked_bounds = boundsOf(prism, p_WTo, margin_m);
    tree.collide(&asked_bounds, &query,
                 [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
                   auto& asked = *static_cast<Query*>(data);
                   const void* met = a->getUserData() ? a->getUserData() : b->getUserData();
                   const auto& other = *static_cast<const UprightPrism*>(met);
                   const Parts& parts = asked.parts;
                   if (!asked.shape) asked.shape = parts.shapeOnWay(asked.prism, asked.p_WTo);
                   const auto of_other = parts.shapes->find(other.outline, other.height_m, 0);
                   asked.met[static_cast<std::size_t>(&other - parts.others.data())] =
                       collide(*asked.shape, asked.prism.p_WCentre, *of_other, other.p_WCentre);
                   return false;  // there may be more
                 });
    return std::move(query.met);
  }

  Workbench workbench;
  std::vector<UprightPrism> others;
  std::vector<double> reaches_m;  // [others]
  double margin_m;
  std::size_t first_unmeasured = 0;  // others.size() if there is none
  std::shared_ptr<PrismShapes> shapes;
  std::vector<fcl::CollisionObjectd> bounds;
  fcl::DynamicAABBTreeCollisionManagerd tree;
};

FclScene::FclScene(const Workbench& workbench, std::vector<UprightPrism> others, double margin_m,
                   std::shared_ptr<PrismShapes> shapes) {
  if (!(margin_m > 0)) {
    throw std::invalid_argument("margin_m is " + std::to_string(margin_m) + ", expected > 0");
  }
  if (!shapes) shapes = std::make_shared<PrismShapes>();
  parts_ = std::make_unique<const Parts>(workbench, std::move(others), margin_m, std::move(shapes));
}

FclScene::~FclScene() = default;
FclScene::FclScene(FclScene&&) noexcept = default;
FclScene& FclScene::operator=(FclScene&&) noexcept = default;

Verdict FclScene::check(const UprightPrism& target) const {
  return checkMotion(target, target.p_WCentre);
}

Verdict FclScene::checkMotion(const UprightPrism& target, const Eigen::Vector2d& p_WTo) const {
  const std::vector<UprightPrism>& others = parts_->others;
  if (parts_->first_unmeasured < others.size()) {
    return {Invalidity::kCheckFailed, static_cast<std::uint32_t>(parts_->first_unmeasured), 0};
  }
  if (!target.measured() || !p_WTo.allFinite()) return {Invalidity::kCheckFailed, 0, 0};
  UprightPrism moved = target;
  moved.p_WCentre = p_WTo;
  Verdict nearest{Invalidity::kNone, 0,
                  std::min(edgeClearance_m(parts_->workbench, target),
                           edgeClearance_m(parts_->workbench, moved))};
  if (nearest.clearance_m < 0) return {Invalidity::kWorkbenchEdge, 0, nearest.clearance_m};

  std::vector<bool> met;
  try {
    met = parts_->met(target, p_WTo);
  } catch (const std::exception&) {
    return {Invalidity::kCheckFailed, 0, 0};
  }
  const double reach_m = reachOf_m(target);
  for (std::size_t i = 0; i < others.size(); ++i) {
    const double apart_m = distanceToWay_m(others[i].p_WCentre, target.p_WCentre, p_WTo) - reach_m -
                           parts_->reaches_m[i];
    const double watched_m = std::max(nearest.clearance_m, parts_->margin_m + kContactTolerance_m);
    if (!met[i] && kLeastShare * apart_m > watched_m) continue;  // too far to change the answer
    const double distance_m = clearanceAlong_m(target, p_WTo, others[i]);
    if (met[i] || std::abs(distance_m - parts_->margin_m) <= kContactTolerance_m) {
      return {Invalidity::kCollision, static_cast<std::uint32_t>(i), distance_m};
    }
    nearest.clearance_m = std::min(nearest.clearance_m, distance_m);
  }
  return nearest;
}

}  // namespace conceptplan
