#include "conceptplan/learner/background.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

constexpr int kHoleMargin_px = 10;
/// Width of the strip around the hole that is compared.
constexpr int kRim_px = 5;
/// Shadows and edges reach this far around objects; no piece of floor is taken there.
constexpr int kShy_px = 8;
constexpr int kReach_x_px = 96;
constexpr int kReach_y_px = 64;
constexpr int kCoarseStep_px = 2;

struct Pixel {
  int x = 0;
  int y = 0;
};

using Color = Eigen::Vector3f;
using Eigen::Vector2f;

/// 1 where a pixel that is set lies within a square of that margin.
std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& set, int width, int margin) {
  const auto height = static_cast<int>(set.size()) / width;
  const auto along = [](const std::vector<std::uint8_t>& from, int lines, int line_step, int length,
                        int step, int margin) {
    std::vector<std::uint8_t> result(from.size(), 0);
    for (int line = 0; line < lines; ++line) {
      int near = -margin - 1;  // the last position that is set
      const auto at = [&](int i) { return static_cast<std::size_t>(line * line_step + i * step); };
      for (int i = 0; i < length + margin; ++i) {
        if (i < length && from[at(i)] != 0) near = i;
        if (i >= margin && i - near <= 2 * margin) result[at(i - margin)] = 1;
      }
    }
    return result;
  };
  return along(along(set, height, width, width, 1, margin), width, 1, height, width, margin);
}

/// A plane as a camera sees it: inverse depth is linear in the pixels.
class SeenPlane {
 public:
  /// The plane through those pixels, by least squares; then once more without those off it.
  SeenPlane(const RgbdImage& image, const std::vector<Pixel>& pixels) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Pixel pixel : pixels) sum += Eigen::Vector2d(pixel.x, pixel.y);
    if (!pixels.empty()) middle_ = (sum / static_cast<double>(pixels.size())).cast<float>();
    constexpr double kTolerance = 0.02;
    for (const bool chosen : {false, true}) {
      Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      for (const Pixel pixel : pixels) {
        const double depth_m =
            image.depth_m[static_cast<std::size_t>(pixel.y * image.width + pixel.x)];
        if (!(depth_m > 0) || (chosen && std::abs(inverseDepth(pixel) * depth_m - 1) > kTolerance))
          continue;
        const Vector2f way = wayTo(pixel);
        const Eigen::Vector3d at(way.x(), way.y(), 1);
        products += at * at.transpose();
        right += at / depth_m;
      }
      const Eigen::Vector3d found = products.fullPivLu().solve(right);
      if (!found.allFinite() || found.z() <= 0) return;
      gradient_ = (found.head<2>() / found.z()).cast<float>();
      inverse_m_ = static_cast<float>(found.z());
    }
  }

  /// Metres along the camera's axis; 0 where the plane is not seen.
  float depth_m(Pixel pixel) const {
    const float inverse = inverseDepth(pixel);
    return inverse > 0 ? 1 / inverse : 0;
  }

  /// Where a point of the plane is seen after the move along it that takes the middle by `offset`.
  Vector2f moved(Pixel pixel, Vector2f offset) const {
    const Vector2f way = wayTo(pixel);
    const float nearness = 1 + gradient_.dot(way);
    return middle_ + (way + nearness * offset) / (1 - nearness * gradient_.dot(offset));
  }

 private:
  Vector2f wayTo(Pixel pixel) const {
    return Vector2f(static_cast<float>(pixel.x), static_cast<float>(pixel.y)) - middle_;
  }

  float inverseDepth(Pixel pixel) const { return inverse_m_ * (1 + gradient_.dot(wayTo(pixel))); }

  Vector2f middle_ = Vector2f::Zero();
  Vector2f gradient_ = Vector2f::Zero();  ///< of the inverse depth, as a share of the middle's
  float inverse_m_ = 0;                   ///< at the middle; 0 where nothing is known
};

/// A hole, what lies around it, and where floor can be taken from.
class HoleFilling {
 public:
  HoleFilling(const RgbdImage& image, const std::vector<std::uint8_t>& hole)
      : image_(image),
        usable_(usable(image)),
        hole_(pixels([&](std::size_t i) { return hole[i] != 0; })),
        rim_(pixels([&, near = grown(hole, image.width, kRim_px)](std::size_t i) {
          return near[i] != 0 && hole[i] == 0 && image.mask[i] == 0;
        })),
        plane_(image, rim_) {}

  /// Fills the colours of the hole.
  void fillColors(std::vector<std::uint8_t>& rgb) const {
    const std::optional<Vector2f> piece = bestPiece();
    const auto taken = [&](Pixel pixel) -> Color {
      return piece ? colorBetween(plane_.moved(pixel, *piece)) : Color::Zero();
    };
    std::vector<Color> differences;
    for (const Pixel pixel : rim_) differences.push_back(color(pixel) - taken(pixel));
    for (const Pixel pixel : hole_) {
      const Color value = taken(pixel) + spread(differences, pixel);
      for (int channel = 0; channel < 3; ++channel)
        rgb[3 * at(pixel) + static_cast<std::size_t>(channel)] =
            static_cast<std::uint8_t>(std::lround(std::clamp(value[channel], 0.0F, 255.0F)));
    }
  }

  /// Fills the depth where the mask has the instance, and takes it out of the mask.
  void fillDepth(std::vector<float>& depth_m, std::vector<std::uint8_t>& mask,
                 std::uint8_t instance) const {
    for (const Pixel pixel : hole_) {
      if (mask[at(pixel)] != instance) continue;
      depth_m[at(pixel)] = plane_.depth_m(pixel);
      mask[at(pixel)] = 0;
    }
  }

 private:
  static std::vector<std::uint8_t> usable(const RgbdImage& image) {
    std::vector<std::uint8_t> objects(image.mask.size());
    std::transform(image.mask.begin(), image.mask.end(), objects.begin(),
                   [](std::uint8_t id) { return static_cast<std::uint8_t>(id != 0); });
    objects = grown(objects, image.width, kShy_px);
    for (std::uint8_t& flag : objects) flag ^= 1U;
    return objects;
  }

  template <typename Contains>
  std::vector<Pixel> pixels(Contains contains) const {
    std::vector<Pixel> found;
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x)
        if (contains(at({x, y}))) found.push_back({x, y});
    return found;
  }

  std::size_t at(Pixel pixel) const {
    return static_cast<std::size_t>(pixel.y * image_.width + pixel.x);
  }

  Color color(Pixel pixel) const {
    const std::uint8_t* rgb = &image_.rgb[3 * at(pixel)];
    return Color(rgb[0], rgb[1], rgb[2]);
  }

  Color colorBetween(Vector2f point) const {
    const int x = std::clamp(static_cast<int>(point.x()), 0, image_.width - 2);
    const int y = std::clamp(static_cast<int>(point.y()), 0, image_.height - 2);
    const float u = point.x() - static_cast<float>(x), v = point.y() - static_cast<float>(y);
    return (1 - v) * ((1 - u) * color({x, y}) + u * color({x + 1, y})) +
           v * ((1 - u) * color({x, y + 1}) + u * color({x + 1, y + 1}));
  }

  /// The pixel of the floor there, if it can be taken.
  std::optional<Pixel> floorAt(Vector2f point) const {
    if (!(point.x() >= 0 && point.y() >= 0)) return std::nullopt;
    const Pixel pixel{static_cast<int>(point.x() + 0.5F), static_cast<int>(point.y() + 0.5F)};
    if (pixel.x >= image_.width || pixel.y >= image_.height || usable_[at(pixel)] == 0)
      return std::nullopt;
    return pixel;
  }

  /// How the surroundings of the hole and of the piece at that offset differ; nothing where the
  /// piece is not whole. A difference in brightness alone counts a quarter.
  std::optional<float> mismatch(Vector2f offset) const {
    constexpr std::size_t kStride = 7;  // what is unusable is wider than this
    for (std::size_t i = 0; i < hole_.size(); i += kStride)
      if (!floorAt(plane_.moved(hole_[i], offset))) return std::nullopt;
    Color sum = Color::Zero();
    float squares = 0, count = 0;
    constexpr std::size_t kRimStride = 5;
    for (std::size_t i = 0; i < rim_.size(); i += kRimStride) {
      const std::optional<Pixel> piece = floorAt(plane_.moved(rim_[i], offset));
      if (!piece) return std::nullopt;
      const Color difference = color(rim_[i]) - color(*piece);
      sum += difference;
      squares += difference.squaredNorm();
      ++count;
    }
    return squares / count - 0.75F * (sum / count).squaredNorm();
  }

  /// Offset of the piece of floor that fits best.
  std::optional<Vector2f> bestPiece() const {
    std::optional<Vector2f> best;
    float least = 0;
    const auto consider = [&](Vector2f offset) {
      const std::optional<float> cost = mismatch(offset);
      if (!cost || (best && *cost >= least)) return;
      best = offset;
      least = *cost;
    };
    if (rim_.empty()) return std::nullopt;
    for (int y = -kReach_y_px; y <= kReach_y_px; y += kCoarseStep_px)
      for (int x = -kReach_x_px; x <= kReach_x_px; x += kCoarseStep_px)
        consider(Vector2f(static_cast<float>(x), static_cast<float>(y)));
    if (best)
      for (const Vector2f coarse = *best; const float y : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F})
        for (const float x : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) consider(coarse + Vector2f(x, y));
    return best;
  }

  /// The differences at the rim, weighted by nearness to a pixel.
  Color spread(const std::vector<Color>& differences, Pixel pixel) const {
    Color sum = Color::Zero();
    float weights = 0;
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const int x = rim_[i].x - pixel.x, y = rim_[i].y - pixel.y;
      const auto nearness = 1.0F / static_cast<float>(x * x + y * y + kRim_px * kRim_px);
      sum += nearness * nearness * differences[i];
      weights += nearness * nearness;
    }
    return weights > 0 ? Color(sum / weights) : Color::Zero();
  }

  const RgbdImage& image_;
  std::vector<std::uint8_t> usable_;
  std::vector<Pixel> hole_, rim_;
  SeenPlane plane_;
};

}  // namespace

std::vector<std::uint8_t> holeOf(const RgbdImage& image, std::uint8_t instance) {
  std::vector<std::uint8_t> hole(image.mask.size());
  std::transform(image.mask.begin(), image.mask.end(), hole.begin(),
                 [&](std::uint8_t id) { return static_cast<std::uint8_t>(id == instance); });
  hole = grown(hole, image.width, kHoleMargin_px);
  for (std::size_t i = 0; i < hole.size(); ++i)
    if (image.mask[i] != 0 && image.mask[i] != instance) hole[i] = 0;
  return hole;
}

Background backgroundWithout(const RgbdImage& image, std::uint8_t instance) {
  const auto size = static_cast<std::size_t>(image.width * image.height);
  if (image.rgb.size() != 3 * size || image.depth_m.size() != size || image.mask.size() != size)
    throw std::invalid_argument("backgroundWithout: colours, depth and mask are not of one size");
  if (instance == 0 ||
      std::find(image.mask.begin(), image.mask.end(), instance) == image.mask.end())
    throw std::invalid_argument("backgroundWithout: the picture has no instance " +
                                std::to_string(instance));
  Background background{image, holeOf(image, instance)};
  const HoleFilling filling(image, background.hole);
  filling.fillColors(background.image.rgb);
  filling.fillDepth(background.image.depth_m, background.image.mask, instance);
  return background;
}

}  // namespace conceptplan
