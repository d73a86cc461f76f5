#pragma once

#include <fcl/narrowphase/collision_object.h>

#include <vector>

#include "conceptplan/domain/model/upright_cylinder.hpp"

namespace conceptplan {

/// @param grown_m is added to the radius.
fcl::CollisionObjectd bodyOf(const UprightCylinder& cylinder, double grown_m);

/// What together is all that the cylinder sweeps while it goes straight to `p_WTo`: itself, itself
/// there, and a box between them; itself alone where it stays.
std::vector<fcl::CollisionObjectd> sweptBodiesOf(const UprightCylinder& cylinder,
                                                 const Eigen::Vector2d& p_WTo, double grown_m);

/// @throws whatever FCL throws.
bool collide(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b);

}  // namespace conceptplan
