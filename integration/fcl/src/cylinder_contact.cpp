#include "conceptplan/fcl/cylinder_contact.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "fcl_bodies.hpp"

namespace conceptplan {

std::string_view name(Contact contact) {
  switch (contact) {
    case Contact::kApart:
      return "apart";
    case Contact::kTouching:
      return "touching";
    case Contact::kOverlapping:
      return "overlapping";
    case Contact::kUndecided:
      break;
  }
  return "undecided";
}

Contact contactOf(const UprightCylinder& a, const UprightCylinder& b, double margin_m) {
  return sweptContactOf(a, a.p_WCentre, b, margin_m);
}

Contact sweptContactOf(const UprightCylinder& a, const Eigen::Vector2d& p_WTo,
                       const UprightCylinder& b, double margin_m) {
  if (!a.measured() || !b.measured() || !p_WTo.allFinite()) return Contact::kUndecided;
  if (std::abs(clearanceAlong_m(a, p_WTo, b) - margin_m) <= kContactTolerance_m) {
    return Contact::kTouching;
  }
  try {
    const auto swept = sweptBodiesOf(a, p_WTo, margin_m);
    const fcl::CollisionObjectd other = bodyOf(b, 0);
    const bool meet = std::any_of(swept.begin(), swept.end(),
                                  [&](const auto& part) { return collide(part, other); });
    return meet ? Contact::kOverlapping : Contact::kApart;
  } catch (const std::exception&) {
    return Contact::kUndecided;
  }
}

}  // namespace conceptplan
