#include "conceptplan/learner/turn_residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace conceptplan {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kContradicted = 1;
constexpr double kHidden = 0.35;
/// Surfaces whose depths differ by less are one.
constexpr double kSameDepth_m = 0.010;
/// A point may be met one pixel away, and is a little worse then.
constexpr double kPixelPenalty = 0.02;
/// One visible point of so many is looked for.
constexpr std::size_t kStride = 5;
/// Pixels beside the object's box in which the floor is seen.
constexpr int kMargin_px = 16;
constexpr double kCoarse_m = 0.016;
constexpr int kCoarseSteps = 2;
constexpr double kFine_m = 0.008;

/// What stays of a surface's colour when the object is dyed.
struct Paint {
  double grey = 0;   ///< 0 coloured, 1 grey
  double light = 0;  ///< 0 black, 1 white
};

Paint paintOf(const std::uint8_t* rgb) {
  const double most = std::max({rgb[0], rgb[1], rgb[2]}),
               least = std::min({rgb[0], rgb[1], rgb[2]});
  // Full up to a third of saturation, with room for noise where it is dark.
  return {std::clamp((most / 3 + 14 - (most - least)) / 14, 0.0, 1.0),
          (rgb[0] + rgb[1] + rgb[2]) / (3 * 255.0)};
}

double difference(const Paint& a, const Paint& b) {
  return std::min(
      1.0, std::abs(a.grey - b.grey) + std::min(a.grey, b.grey) * std::abs(a.light - b.light));
}

struct VisiblePoint {
  Vector3d p_A;  ///< from the foot of the axis
  Paint paint;
};

/// Whether a depth picture says how far something is.
bool isKnown(float depth_m) { return std::isfinite(depth_m) && depth_m > 0; }

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// An object's visible surface, and the picture in which another one's is looked for.
class Surface {
 public:
  Surface(const ObjectView& view, const Camera& camera)
      : image_(view.image),
        instance_(view.instance),
        camera_(camera),
        X_CW_(camera.X_WC.inverse()) {
    if (image_.width != camera.width || image_.height != camera.height)
      throw std::invalid_argument("turnResidual: a picture of " + std::to_string(image_.width) +
                                  " x " + std::to_string(image_.height) +
                                  " is not of the camera's size");
    std::vector<int> pixels;
    int left = image_.width, right = -1, top = image_.height, bottom = -1;
    for (int v = 0; v < image_.height; ++v)
      for (int u = 0; u < image_.width; ++u) {
        if (image_.mask[at(u, v)] != instance_ || !isKnown(image_.depth_m[at(u, v)])) continue;
        pixels.push_back(v * image_.width + u);
        left = std::min(left, u), right = std::max(right, u);
        top = std::min(top, v), bottom = std::max(bottom, v);
      }
    if (pixels.empty()) return;
    std::vector<double> floor_m;
    left = std::max(0, left - kMargin_px), right = std::min(image_.width - 1, right + kMargin_px);
    top = std::max(0, top - kMargin_px), bottom = std::min(image_.height - 1, bottom + kMargin_px);
    for (int v = top; v <= bottom; ++v)
      for (int u = left; u <= right; ++u)
        if (image_.mask[at(u, v)] == 0 && isKnown(image_.depth_m[at(u, v)]))
          floor_m.push_back(p_W(u, v).z());
    p_WFoot_ << view.p_WAxis, median(std::move(floor_m));
    for (std::size_t i = 0; i < pixels.size(); i += kStride) {
      const int u = pixels[i] % image_.width, v = pixels[i] / image_.width;
      points_.push_back({p_W(u, v) - p_WFoot_, paintOf(&image_.rgb[3 * at(u, v)])});
    }
  }

  const std::vector<VisiblePoint>& points() const { return points_; }

  /// By how much the picture contradicts that the points, turned, then moved, are of this object.
  double contradiction(const std::vector<VisiblePoint>& points, const Matrix2d& turn,
                       const Vector2d& moved_m) const {
    double sum = 0;
    for (const VisiblePoint& point : points) {
      Vector3d p_A = point.p_A;
      p_A.head<2>() = turn * point.p_A.head<2>() + moved_m;
      const Vector3d p_C = X_CW_ * (p_WFoot_ + p_A);
      const Vector2d pixel = camera_.center_px + camera_.focal_px * p_C.head<2>() / p_C.z();
      const bool in_view = p_C.z() > 0 && pixel.x() >= 0 && pixel.x() < image_.width &&
                           pixel.y() >= 0 && pixel.y() < image_.height;
      sum += in_view ? contradiction(point.paint, static_cast<int>(pixel.x()),
                                     static_cast<int>(pixel.y()), p_C.z())
                     : kHidden;
    }
    return sum / static_cast<double>(points.size());
  }

 private:
  std::size_t at(int u, int v) const { return static_cast<std::size_t>(v * image_.width + u); }

  Vector3d p_W(int u, int v) const {
    return camera_.unproject({u + 0.5, v + 0.5}, image_.depth_m[at(u, v)]);
  }

  double contradiction(const Paint& paint, int u, int v, double depth_m) const {
    double least = std::numeric_limits<double>::infinity();
    for (int dv = -1; dv <= 1; ++dv)
      for (int du = -1; du <= 1; ++du)
        least = std::min(least, kPixelPenalty * (du * du + dv * dv) +
                                    contradictionAt(paint, u + du, v + dv, depth_m));
    return std::isfinite(least) ? least : kHidden;
  }

  /// Infinite where nothing is known.
  double contradictionAt(const Paint& paint, int u, int v, double depth_m) const {
    if (u < 0 || u >= image_.width || v < 0 || v >= image_.height) return kHidden;
    const std::size_t pixel = at(u, v);
    const double seen_m = image_.depth_m[pixel];
    if (!isKnown(image_.depth_m[pixel])) return std::numeric_limits<double>::infinity();
    if (image_.mask[pixel] != instance_)
      return image_.mask[pixel] != 0 && seen_m < depth_m ? kHidden : kContradicted;
    if (depth_m > seen_m + kSameDepth_m) return kHidden;
    if (depth_m < seen_m - kSameDepth_m) return kContradicted;
    return difference(paint, paintOf(&image_.rgb[3 * pixel]));
  }

  const RgbdImage& image_;
  std::uint8_t instance_;
  const Camera& camera_;
  Eigen::Isometry3d X_CW_;
  Vector3d p_WFoot_ = Vector3d::Zero();
  std::vector<VisiblePoint> points_;
};

/// The rotation matrix of quarter turns, exact.
Matrix2d turnBy(int quarter_turns) {
  constexpr std::array<double, 4> kCosine{1, 0, -1, 0};
  const auto turns = static_cast<std::size_t>((quarter_turns % 4 + 4) % 4);
  const double cosine = kCosine[turns], sine = kCosine[(turns + 3) % 4];
  return (Matrix2d() << cosine, -sine, sine, cosine).finished();
}

}  // namespace

double turnResidual(const ObjectView& before, const ObjectView& after, int quarter_turns,
                    const Camera& camera) {
  const Surface first(before, camera), second(after, camera);
  if (first.points().empty() || second.points().empty()) return kContradicted;
  const Matrix2d turn = turnBy(quarter_turns), back = turn.transpose();
  const auto residual = [&](const Vector2d& moved_m) {
    return 0.5 * (second.contradiction(first.points(), turn, moved_m) +
                  first.contradiction(second.points(), back, -(back * moved_m)));
  };
  double least = std::numeric_limits<double>::infinity();
  // Moves by what `place` makes of each step of a grid, and keeps the best.
  const auto search = [&](int steps, double step_m, const auto& place) {
    Vector2d best(0, 0);
    for (int dy = -steps; dy <= steps; ++dy)
      for (int dx = -steps; dx <= steps; ++dx) {
        const Vector2d moved_m = place(Vector2d(step_m * dx, step_m * dy));
        const double here = residual(moved_m);
        if (here < least) least = here, best = moved_m;
      }
    return best;
  };
  // An axis that is off in both pictures moves what turns about it.
  const int coarse_steps = turn.isIdentity() ? 0 : kCoarseSteps;
  const Vector2d coarse_m = search(coarse_steps, kCoarse_m, [&](const Vector2d& off_m) {
    return Vector2d(off_m - turn * off_m);
  });
  search(1, kFine_m, [&](const Vector2d& off_m) { return Vector2d(coarse_m + off_m); });
  return least;
}

}  // namespace conceptplan
