#include "conceptplan/domain/model/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace conceptplan {
namespace {

constexpr std::size_t kCount = Outline::kDirections;
constexpr double kSameCorner_m = 1e-9;

double angle_rad(std::size_t k) { return 2 * std::numbers::pi * static_cast<double>(k) / kCount; }

std::array<Eigen::Vector2d, kCount> unitVectors() {
  std::array<Eigen::Vector2d, kCount> directions;
  for (std::size_t k = 0; k < kCount; ++k) {
    directions[k] = {std::cos(angle_rad(k)), std::sin(angle_rad(k))};
  }
  return directions;
}

/// The sine of the angle between a direction and the n-th after it. @pre n < kCount
double sineOfSteps(std::size_t n) { return outlineDirection(n).y(); }

/// Where the lines of directions k and k + 1 cross.
Eigen::Vector2d crossing(const Outline& outline, std::size_t k) {
  const std::size_t next = (k + 1) % kCount;
  const Eigen::Vector2d& a = outlineDirection(k);
  const Eigen::Vector2d& b = outlineDirection(next);
  const double of_a = outline.support_m[k] / sineOfSteps(1);
  const double of_b = outline.support_m[next] / sineOfSteps(1);
  return {b.y() * of_a - a.y() * of_b, a.x() * of_b - b.x() * of_a};
}

}  // namespace

const Eigen::Vector2d& outlineDirection(std::size_t k) {
  static const std::array<Eigen::Vector2d, kCount> directions = unitVectors();
  return directions[k];
}

Outline outlineOfDisc(double radius_m) {
  Outline outline;
  outline.support_m.fill(radius_m);
  return outline;
}

Outline outlineOfSquare(double half_edge_m) {
  Outline outline;
  for (std::size_t k = 0; k < kCount; ++k) {
    outline.support_m[k] = half_edge_m * outlineDirection(k).lpNorm<1>();
  }
  return outline;
}

Outline tightened(const Outline& outline) {
  Outline tight = outline;
  // What two lines on either side of a direction, less than half a turn apart, leave of it: the
  // dual of its linear program.
  for (std::size_t k = 0; k < kCount; ++k) {
    for (std::size_t before = 1; before < kCount / 2; ++before) {
      for (std::size_t after = 1; before + after < kCount / 2; ++after) {
        const double left = outline.support_m[(k + kCount - before) % kCount];
        const double right = outline.support_m[(k + after) % kCount];
        const double reached =
            (sineOfSteps(after) * left + sineOfSteps(before) * right) / sineOfSteps(before + after);
        tight.support_m[k] = std::min(tight.support_m[k], reached);
      }
    }
  }
  return tight;
}

Outline clipped(const Outline& outline, const Outline& by) {
  Outline both;
  for (std::size_t k = 0; k < kCount; ++k) {
    both.support_m[k] = std::min(outline.support_m[k], by.support_m[k]);
  }
  return both == outline ? outline : tightened(both);
}

Outline unionOf(const Outline& a, const Outline& b) {
  Outline both;
  for (std::size_t k = 0; k < kCount; ++k) {
    both.support_m[k] = std::max(a.support_m[k], b.support_m[k]);
  }
  return both;
}

OutlineBox boxOf(const Outline& outline) {
  constexpr std::size_t kQuarter = kCount / 4;
  const auto& support_m = outline.support_m;
  return {{-support_m[2 * kQuarter], -support_m[3 * kQuarter]},
          {support_m[0], support_m[kQuarter]}};
}

double circumradius_m(const Outline& outline) {
  double farthest_m = 0;
  for (std::size_t k = 0; k < kCount; ++k) {
    farthest_m = std::max(farthest_m, crossing(outline, k).norm());
  }
  return farthest_m;
}

std::vector<Eigen::Vector2d> cornersOf(const Outline& outline) {
  std::vector<Eigen::Vector2d> corners;
  for (std::size_t k = 0; k < kCount; ++k) {
    const Eigen::Vector2d corner = crossing(outline, k);
    if (corners.empty() || (corner - corners.back()).norm() > kSameCorner_m) {
      corners.push_back(corner);
    }
  }
  while (corners.size() > 1 && (corners.back() - corners.front()).norm() <= kSameCorner_m) {
    corners.pop_back();
  }
  return corners;
}

}  // namespace conceptplan
