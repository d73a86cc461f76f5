#pragma once

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision_object.h>

#include <memory>

#include "conceptplan/domain/model/upright_prism.hpp"

namespace conceptplan {

/// What stands on the outline, `grown_m` larger to all sides, about its place as origin. The
/// outline is that of a measured prism. FCL takes tens of microseconds to make one.
std::shared_ptr<const fcl::Convexd> shapeOf(const Outline& outline, double height_m,
                                            double grown_m);

/// All that the prism, grown likewise, sweeps along a way, about its place at the start; `shapeOf`
/// where the way is zero.
std::shared_ptr<const fcl::Convexd> sweptShapeOf(const UprightPrism& prism,
                                                 const Eigen::Vector2d& way, double grown_m);

/// The upright box, in W, around a prism that goes straight to `p_WTo`, grown likewise.
fcl::CollisionObjectd boundsOf(const UprightPrism& prism, const Eigen::Vector2d& p_WTo,
                               double grown_m);

/// Whether two shapes meet whose places are there. @throws whatever FCL throws.
bool collide(const fcl::Convexd& a, const Eigen::Vector2d& p_WA, const fcl::Convexd& b,
             const Eigen::Vector2d& p_WB);

}  // namespace conceptplan
