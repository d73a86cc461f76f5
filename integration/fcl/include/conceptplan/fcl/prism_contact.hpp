#pragma once

#include <string_view>

#include "conceptplan/domain/model/upright_prism.hpp"

namespace conceptplan {

/// How two bodies stand to each other.
enum class Contact {
  kApart,
  kTouching,  ///< so near that FCL's answer depends on rounding; counts as overlapping
  kOverlapping,
  kUndecided  ///< a body is not measured, or FCL threw
};

/// "apart", "touching", "overlapping", "undecided".
std::string_view name(Contact contact);

/// Nearer than this to exact contact FCL is not asked, metres.
inline constexpr double kContactTolerance_m = 1e-4;

/// Whether `a`, grown by the margin, meets `b`. Thread-safe.
///
/// FCL is asked whether there is a collision, without contacts. Its distance query is left out with
/// intent: its GJK aborts the process on an assertion for some poses (FCL 0.7, gjk_libccd-inl.h,
/// doSimplex2). Distances of prisms that stand on one plane are those of their outlines.
Contact contactOf(const UprightPrism& a, const UprightPrism& b, double margin_m);

/// The same of all that `a` sweeps while it goes straight to `p_WTo`, a convex body too.
Contact sweptContactOf(const UprightPrism& a, const Eigen::Vector2d& p_WTo, const UprightPrism& b,
                       double margin_m);

}  // namespace conceptplan
