#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace conceptplan {

/// A convex outline on the workbench about a place of its own: the discrete orientation polytope of
/// 16 directions, {p : n_k . p <= support_m[k]} with n_k at k times 22.5 degrees from the x axis.
/// Outlines here are tight: each of the 16 lines touches the set. So the outline of a sum of two
/// sets, of their union's hull and of a quarter turn are sums, maxima and shifts of supports.
/// Source: J. T. Klosowski et al., Efficient collision detection using bounding volume hierarchies
/// of k-DOPs, IEEE TVCG 4 (1998).
struct Outline {
  static constexpr std::size_t kDirections = 16;

  std::array<double, kDirections> support_m{};  ///< > 0 where the place is inside

  bool operator==(const Outline&) const = default;
};

/// n_k, of length one. @pre k < Outline::kDirections
const Eigen::Vector2d& outlineDirection(std::size_t k);

/// The opposite direction's number.
constexpr std::size_t opposite(std::size_t k) {
  return (k + Outline::kDirections / 2) % Outline::kDirections;
}

/// The regular outline around a disc.
Outline outlineOfDisc(double radius_m);
Outline outlineOfSquare(double half_edge_m);

/// The same set with each support no larger than the set reaches. @pre all supports > 0
Outline tightened(const Outline& outline);

/// The intersection. @pre all supports > 0
Outline clipped(const Outline& outline, const Outline& by);

/// The outline of both together.
Outline unionOf(const Outline& a, const Outline& b);

/// An upright box about a place.
struct OutlineBox {
  Eigen::Vector2d low_m;   ///< its corner towards -x and -y
  Eigen::Vector2d high_m;  ///< the opposite one
};

/// The box around an outline.
OutlineBox boxOf(const Outline& outline);

/// The distance of the corner that is farthest from the place.
double circumradius_m(const Outline& outline);

/// The corners, counter-clockwise, none twice. @pre the outline is tight
std::vector<Eigen::Vector2d> cornersOf(const Outline& outline);

}  // namespace conceptplan
