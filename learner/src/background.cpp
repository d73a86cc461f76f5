#include "conceptplan/learner/background.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace conceptplan {
namespace {

/// The first of them at which a piece of floor fits is taken.
constexpr std::array kHoleMargins_px{13, 10, 7};
/// Width of the strip around the hole that is compared.
constexpr int kRim_px = 5;
/// Shadows and edges reach this far around objects; no piece of floor is taken there.
constexpr int kShy_px = 8;
constexpr int kReach_px = 128;
constexpr int kCoarseStep_px = 2;
/// Where no piece of floor is taken is wider than this.
constexpr int kHoleStride_px = 8;
/// Differences are spread from means over squares of the rim.
constexpr int kBlock_px = 6;
/// Of 255 levels.
constexpr float kMostLight = 25;
constexpr std::size_t kRimSamples = 128;
constexpr float kFirstRimSamples = 24;
/// As a share of the depth.
constexpr float kPlaneTolerance = 0.03F;
/// Of the rim that may be on the plane where the piece is off it, or the other way round.
constexpr float kMostOffPlane = 0.05F;

struct Pixel {
  int x = 0;
  int y = 0;
};

using Color = Eigen::Vector3f;
using Eigen::Vector2f;

Vector2f pointOf(Pixel pixel) { return {static_cast<float>(pixel.x), static_cast<float>(pixel.y)}; }

/// 1 where a pixel that is set lies within a square of that margin.
std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& set, int width, int margin) {
  const auto height = width > 0 ? static_cast<int>(set.size()) / width : 0;
  const auto along = [margin](const std::vector<std::uint8_t>& from, int lines, int line_step,
                              int length, int step) {
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
  return along(along(set, height, width, width, 1), width, 1, height, width);
}

/// A plane as a camera sees it: inverse depth is linear in the pixels.
class SeenPlane {
 public:
  /// The plane through those pixels, by least squares; again and again without those off it.
  SeenPlane(const RgbdImage& image, const std::vector<Pixel>& pixels) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Pixel pixel : pixels) sum += Eigen::Vector2d(pixel.x, pixel.y);
    if (!pixels.empty()) middle_ = (sum / static_cast<double>(pixels.size())).cast<float>();
    for (const double tolerance : {std::numeric_limits<double>::infinity(), 0.1, 0.05, 0.02}) {
      Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      for (const Pixel pixel : pixels) {
        const double depth_m =
            image.depth_m[static_cast<std::size_t>(pixel.y * image.width + pixel.x)];
        if (!std::isfinite(depth_m) || depth_m <= 0 ||
            std::abs(inverseDepth(pixel) * depth_m - 1) > tolerance)
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

  /// False only for what is known to be nearer or farther than the plane.
  bool mayHold(Pixel pixel, float depth_m) const {
    return inverse_m_ == 0 || !(depth_m > 0) ||
           !(std::abs(inverseDepth(pixel) * depth_m - 1) > kPlaneTolerance);
  }

  /// Metres along the camera's axis; 0 where the plane is not seen.
  float depth_m(Pixel pixel) const {
    const float inverse = inverseDepth(pixel);
    return inverse > 0 ? 1 / inverse : 0;
  }

  /// Where a point of the plane is seen after a move along it: one that moves what is as far away
  /// as the middle by `offset`, in pixels of there. Not a number where the plane is not seen.
  Vector2f moved(Pixel pixel, Vector2f offset) const {
    const Vector2f way = wayTo(pixel);
    const float nearness = 1 + gradient_.dot(way);
    const float nearer = 1 - nearness * gradient_.dot(offset);
    if (nearness <= 0 || nearer <= 0)
      return Vector2f::Constant(std::numeric_limits<float>::quiet_NaN());
    return middle_ + (way + nearness * offset) / nearer;
  }

 private:
  Vector2f wayTo(Pixel pixel) const { return pointOf(pixel) - middle_; }

  float inverseDepth(Pixel pixel) const { return inverse_m_ * (1 + gradient_.dot(wayTo(pixel))); }

  Vector2f middle_ = Vector2f::Zero();
  Vector2f gradient_ = Vector2f::Zero();  ///< of the inverse depth, as a share of the middle's
  float inverse_m_ = 0;                   ///< at the middle; 0 where nothing is known
};

/// How the rim differs from that of a piece, in one place.
struct Difference {
  Color color = Color::Zero();
  Vector2f place = Vector2f::Zero();
  float pixels = 0;
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
        plane_(image, rim_) {
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        on_plane_.push_back(plane_.mayHold({x, y}, image.depth_m[at({x, y})]) ? 1 : 0);
    std::copy_if(hole_.begin(), hole_.end(), std::back_inserter(hole_samples_), [](Pixel pixel) {
      return pixel.x % kHoleStride_px == 0 && pixel.y % kHoleStride_px == 0;
    });
    // The first quarter of them lies all around already.
    const std::size_t stride = rim_.size() / kRimSamples + 1;
    for (std::size_t first = 0; first < 4; ++first)
      for (std::size_t i = first * stride; i < rim_.size(); i += 4 * stride)
        rim_samples_.push_back(rim_[i]);
    piece_ = bestPiece();
  }

  /// Whether there is a piece of floor that is whole.
  bool hasPiece() const { return piece_.has_value(); }

  /// Fills the colours of the hole.
  void fillColors(std::vector<std::uint8_t>& rgb) const {
    const auto taken = [&](Pixel pixel) -> Color {
      return piece_ ? colorAround(plane_.moved(pixel, *piece_)) : Color::Zero();
    };
    Color mean = Color::Zero();
    for (const Pixel pixel : rim_) mean += color(pixel) - taken(pixel);
    mean /= std::max(1.0F, static_cast<float>(rim_.size()));
    std::map<std::pair<int, int>, Difference> blocks;
    for (const Pixel pixel : rim_) {
      const Color difference = color(pixel) - taken(pixel);
      // What differs as much is an edge out of its place; light differs less.
      if (piece_ && (difference - mean).cwiseAbs().maxCoeff() > kMostLight) continue;
      Difference& block = blocks[{pixel.y / kBlock_px, pixel.x / kBlock_px}];
      block.color += difference;
      block.place += pointOf(pixel);
      ++block.pixels;
    }
    std::vector<Difference> differences;
    for (const auto& [place, block] : blocks)
      differences.push_back({block.color / block.pixels, block.place / block.pixels, block.pixels});
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

  /// The colour between the four pixels around a point, or around the nearest one in the frame.
  Color colorAround(Vector2f point) const {
    const auto most_x = static_cast<float>(image_.width - 1);
    const auto most_y = static_cast<float>(image_.height - 1);
    const float right = std::min(std::max(0.0F, point.x()), most_x);  // 0 if not a number
    const float down = std::min(std::max(0.0F, point.y()), most_y);
    const Pixel first{static_cast<int>(right), static_cast<int>(down)};
    const Pixel last{std::min(first.x + 1, image_.width - 1),
                     std::min(first.y + 1, image_.height - 1)};
    const float u = right - static_cast<float>(first.x), v = down - static_cast<float>(first.y);
    return (1 - v) * ((1 - u) * color(first) + u * color({last.x, first.y})) +
           v * ((1 - u) * color({first.x, last.y}) + u * color(last));
  }

  /// The pixel of the floor there, if it can be taken.
  std::optional<Pixel> floorAt(Vector2f point) const {
    if (!(point.x() >= 0 && point.y() >= 0 && point.x() < static_cast<float>(image_.width) - 0.5F &&
          point.y() < static_cast<float>(image_.height) - 0.5F))
      return std::nullopt;
    const Pixel pixel{std::min(static_cast<int>(point.x() + 0.5F), image_.width - 1),
                      std::min(static_cast<int>(point.y() + 0.5F), image_.height - 1)};
    if (usable_[at(pixel)] == 0) return std::nullopt;
    return pixel;
  }

  /// How the surroundings of the hole and of the piece at that offset differ: the mean squared
  /// difference, in which one of the brightness alone counts a quarter. Nothing where the piece is
  /// not whole or not of one plane as the rim is, or where a part of the rim shows that it differs
  /// far more than `least`.
  std::optional<float> mismatch(Vector2f offset, float least) const {
    for (const Pixel pixel : hole_samples_)
      if (!floorAt(plane_.moved(pixel, offset))) return std::nullopt;
    Color sum = Color::Zero();
    float squares = 0, count = 0, off_plane = 0;
    const auto cost = [&] { return squares / count - 0.75F * (sum / count).squaredNorm(); };
    for (const Pixel pixel : rim_samples_) {
      const std::optional<Pixel> piece = floorAt(plane_.moved(pixel, offset));
      if (!piece) return std::nullopt;
      if (on_plane_[at(pixel)] != on_plane_[at(*piece)]) ++off_plane;
      const Color difference = color(pixel) - color(*piece);
      sum += difference;
      squares += difference.squaredNorm();
      if (++count == kFirstRimSamples && cost() > 2 * least) return std::nullopt;
    }
    if (off_plane > kMostOffPlane * count) return std::nullopt;
    return cost();
  }

  /// Offset of the piece of floor that fits best.
  std::optional<Vector2f> bestPiece() const {
    std::optional<Vector2f> best;
    float least = std::numeric_limits<float>::infinity();
    const auto consider = [&](Vector2f offset) {
      const std::optional<float> cost = mismatch(offset, least);
      if (!cost || !(*cost < least)) return;
      best = offset;
      least = *cost;
    };
    if (rim_samples_.empty()) return std::nullopt;
    for (int y = -kReach_px; y <= kReach_px; y += kCoarseStep_px)
      for (int x = -kReach_px; x <= kReach_px; x += kCoarseStep_px) consider(pointOf({x, y}));
    if (best)
      for (const Vector2f coarse = *best; const float y : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F})
        for (const float x : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) consider(coarse + Vector2f(x, y));
    return best;
  }

  /// The differences weighted by nearness to a pixel.
  static Color spread(const std::vector<Difference>& differences, Pixel pixel) {
    const Vector2f place = pointOf(pixel);
    Color sum = Color::Zero();
    float weights = 0;
    for (const Difference& difference : differences) {
      const float nearness =
          1 / ((difference.place - place).squaredNorm() + static_cast<float>(kRim_px * kRim_px));
      const float weight = difference.pixels * nearness * nearness;
      sum += weight * difference.color;
      weights += weight;
    }
    return weights > 0 ? Color(sum / weights) : Color::Zero();
  }

  const RgbdImage& image_;
  std::vector<std::uint8_t> usable_, on_plane_;  // [height, width]
  std::vector<Pixel> hole_, hole_samples_, rim_, rim_samples_;
  SeenPlane plane_;
  std::optional<Vector2f> piece_;  // its offset
};

/// 1 where an instance is, grown, except on other instances.
std::vector<std::uint8_t> holeOf(const RgbdImage& image, std::uint8_t instance, int margin) {
  std::vector<std::uint8_t> hole(image.mask.size());
  std::transform(image.mask.begin(), image.mask.end(), hole.begin(),
                 [&](std::uint8_t id) { return static_cast<std::uint8_t>(id == instance); });
  hole = grown(hole, image.width, margin);
  for (std::size_t i = 0; i < hole.size(); ++i)
    if (image.mask[i] != 0 && image.mask[i] != instance) hole[i] = 0;
  return hole;
}

}  // namespace

Background backgroundWithout(const RgbdImage& image, std::uint8_t instance) {
  const auto size = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width <= 0 || image.height <= 0 || image.rgb.size() != 3 * size ||
      image.depth_m.size() != size || image.mask.size() != size)
    throw std::invalid_argument("backgroundWithout: colours, depth and mask are not of one size");
  if (instance == 0 ||
      std::find(image.mask.begin(), image.mask.end(), instance) == image.mask.end())
    throw std::invalid_argument("backgroundWithout: the picture has no instance " +
                                std::to_string(instance));
  Background background{image, {}};
  for (const int margin : kHoleMargins_px) {
    background.hole = holeOf(image, instance, margin);
    const HoleFilling filling(image, background.hole);
    if (!filling.hasPiece() && margin != kHoleMargins_px.back()) continue;
    filling.fillColors(background.image.rgb);
    filling.fillDepth(background.image.depth_m, background.image.mask, instance);
    break;
  }
  return background;
}

}  // namespace conceptplan
