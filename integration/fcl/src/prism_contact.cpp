#include "conceptplan/fcl/prism_contact.hpp"

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

Contact contactOf(const UprightPrism& a, const UprightPrism& b, double margin_m) {
  return sweptContactOf(a, a.p_WCentre, b, margin_m);
}

Contact sweptContactOf(const UprightPrism& a, const Eigen::Vector2d& p_WTo, const UprightPrism& b,
                       double margin_m) {
  if (!a.measured() || !b.measured() || !p_WTo.allFinite()) return Contact::kUndecided;
  if (std::abs(clearanceAlong_m(a, p_WTo, b) - margin_m) <= kContactTolerance_m) {
    return Contact::kTouching;
  }
  try {
    const auto moved = sweptShapeOf(a, p_WTo - a.p_WCentre, margin_m);
    const bool meet = collide(*moved, a.p_WCentre, *shapeOf(b.outline, b.height_m, 0), b.p_WCentre);
    return meet ? Contact::kOverlapping : Contact::kApart;
  } catch (const std::exception&) {
    return Contact::kUndecided;
  }
}

}  // namespace conceptplan
