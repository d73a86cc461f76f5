#include "fcl_bodies.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <cmath>
#include <memory>

namespace conceptplan {
namespace {

fcl::Vector3d middleOf(const Eigen::Vector2d& p_WCentre, double height_m) {
  return {p_WCentre.x(), p_WCentre.y(), 0.5 * height_m};
}

}  // namespace

fcl::CollisionObjectd bodyOf(const UprightCylinder& cylinder, double grown_m) {
  return {std::make_shared<fcl::Cylinderd>(cylinder.radius_m + grown_m, cylinder.height_m),
          fcl::Matrix3d::Identity(), middleOf(cylinder.p_WCentre, cylinder.height_m)};
}

std::vector<fcl::CollisionObjectd> sweptBodiesOf(const UprightCylinder& cylinder,
                                                 const Eigen::Vector2d& p_WTo, double grown_m) {
  std::vector<fcl::CollisionObjectd> bodies{bodyOf(cylinder, grown_m)};
  const Eigen::Vector2d way = p_WTo - cylinder.p_WCentre;
  const double length_m = way.norm();
  if (length_m == 0) return bodies;
  bodies.push_back(bodyOf({p_WTo, cylinder.radius_m, cylinder.height_m}, grown_m));
  const fcl::Matrix3d R_WBox =
      Eigen::AngleAxisd(std::atan2(way.y(), way.x()), fcl::Vector3d::UnitZ()).toRotationMatrix();
  bodies.emplace_back(
      std::make_shared<fcl::Boxd>(length_m, 2 * (cylinder.radius_m + grown_m), cylinder.height_m),
      R_WBox, middleOf(cylinder.p_WCentre + 0.5 * way, cylinder.height_m));
  return bodies;
}

bool collide(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, request, result) > 0;
}

}  // namespace conceptplan
