#include "conceptplan/fcl/fcl_scene.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "conceptplan/fcl/cylinder_contact.hpp"
#include "fcl_bodies.hpp"

namespace conceptplan {

struct FclScene::Parts {
  Parts(const Workbench& bench, std::vector<UprightCylinder> cylinders, double margin)
      : workbench(bench), others(std::move(cylinders)), margin_m(margin) {
    const auto unmeasured = std::find_if_not(
        others.begin(), others.end(), [](const UprightCylinder& body) { return body.measured(); });
    first_unmeasured = static_cast<std::size_t>(unmeasured - others.begin());
    if (first_unmeasured < others.size()) return;  // every check fails
    std::vector<fcl::CollisionObjectd*> registered;
    bodies.reserve(others.size());
    for (UprightCylinder& other : others) {
      bodies.push_back(bodyOf(other, 0));
      bodies.back().setUserData(&other);
      registered.push_back(&bodies.back());
    }
    tree.registerObjects(registered);
    tree.setup();
  }
  Parts(const Parts&) = delete;  // the tree points into the bodies
  Parts& operator=(const Parts&) = delete;

  /// Marks what the body meets. @throws whatever FCL throws.
  void markMet(fcl::CollisionObjectd& body, std::vector<bool>& met) const {
    struct Query {
      const UprightCylinder* first;
      std::vector<bool>& met;
    } query{others.data(), met};
    tree.collide(&body, &query, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
      const auto& asked = *static_cast<Query*>(data);
      const void* other = a->getUserData() ? a->getUserData() : b->getUserData();
      const auto i = static_cast<const UprightCylinder*>(other) - asked.first;
      auto marked = asked.met[static_cast<std::size_t>(i)];
      if (!marked) marked = collide(*a, *b);
      return false;  // there may be more
    });
  }

  Workbench workbench;
  std::vector<UprightCylinder> others;
  double margin_m;
  std::size_t first_unmeasured = 0;  // others.size() if there is none
  std::vector<fcl::CollisionObjectd> bodies;
  fcl::DynamicAABBTreeCollisionManagerd tree;
};

FclScene::FclScene(const Workbench& workbench, std::vector<UprightCylinder> others,
                   double margin_m) {
  if (!(margin_m > 0)) {
    throw std::invalid_argument("margin_m is " + std::to_string(margin_m) + ", expected > 0");
  }
  parts_ = std::make_unique<const Parts>(workbench, std::move(others), margin_m);
}

FclScene::~FclScene() = default;
FclScene::FclScene(FclScene&&) noexcept = default;
FclScene& FclScene::operator=(FclScene&&) noexcept = default;

Verdict FclScene::check(const UprightCylinder& target) const {
  return checkMotion(target, target.p_WCentre);
}

Verdict FclScene::checkMotion(const UprightCylinder& target, const Eigen::Vector2d& p_WTo) const {
  const std::vector<UprightCylinder>& others = parts_->others;
  if (parts_->first_unmeasured < others.size()) {
    return {Invalidity::kCheckFailed, parts_->first_unmeasured, 0};
  }
  if (!target.measured() || !p_WTo.allFinite()) return {Invalidity::kCheckFailed, 0, 0};
  UprightCylinder moved = target;
  moved.p_WCentre = p_WTo;
  Verdict nearest{Invalidity::kNone, 0,
                  std::min(edgeClearance_m(parts_->workbench, target),
                           edgeClearance_m(parts_->workbench, moved))};
  if (nearest.clearance_m < 0) return {Invalidity::kWorkbenchEdge, 0, nearest.clearance_m};

  std::vector<bool> met(others.size(), false);
  try {
    for (auto& part : sweptBodiesOf(target, p_WTo, parts_->margin_m)) parts_->markMet(part, met);
  } catch (const std::exception&) {
    return {Invalidity::kCheckFailed, 0, 0};
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    const double distance_m = clearanceAlong_m(target, p_WTo, others[i]);
    if (met[i] || std::abs(distance_m - parts_->margin_m) <= kContactTolerance_m) {
      return {Invalidity::kCollision, i, distance_m};
    }
    nearest.clearance_m = std::min(nearest.clearance_m, distance_m);
  }
  return nearest;
}

}  // namespace conceptplan
