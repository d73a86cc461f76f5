#include "rendering/scene.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace conceptplan::rendering {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// The pixels that a box of the world covers, and a border of one, within the picture.
PixelBox covered(const View& view, const Eigen::AlignedBox3f& box) {
  Eigen::AlignedBox2f seen;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3f p((corner & 1) != 0 ? box.max().x() : box.min().x(),
                     (corner & 2) != 0 ? box.max().y() : box.min().y(),
                     (corner & 4) != 0 ? box.max().z() : box.min().z());
    seen.extend(view.project(p));
  }
  const auto within = [](float pixel, int end) {
    return static_cast<int>(std::clamp(pixel, 0.0F, static_cast<float>(end)));
  };
  return {within(std::floor(seen.min().x()) - 1, view.width()),
          within(std::floor(seen.min().y()) - 1, view.height()),
          within(std::ceil(seen.max().x()) + 1, view.width()),
          within(std::ceil(seen.max().y()) + 1, view.height())};
}

}  // namespace

View::View(const Camera& camera)
    : axes_(camera.X_WC.linear().cast<float>()),
      eye_(camera.X_WC.translation().cast<float>()),
      center_(camera.center_px.cast<float>()),
      focal_(static_cast<float>(camera.focal_px)),
      width_(camera.width),
      height_(camera.height) {}

void View::setRay(RTCRay8& rays, std::size_t lane, const Vector3f& direction) const {
  rays.org_x[lane] = eye_.x();
  rays.org_y[lane] = eye_.y();
  rays.org_z[lane] = eye_.z();
  rays.dir_x[lane] = direction.x();
  rays.dir_y[lane] = direction.y();
  rays.dir_z[lane] = direction.z();
  rays.tnear[lane] = 0;
  rays.tfar[lane] = 100;
  rays.mask[lane] = ~0U;
}

Vector2f View::project(const Vector3f& p_W) const {
  const Vector3f p = axes_.transpose() * (p_W - eye_);
  return center_ + focal_ * p.head<2>() / std::max(p.z(), 0.05F);
}

Scene::Scene(const World& world, const Look& look, const View& view, const Room& room,
             LightMap light_map, std::size_t first_index)
    : look_(look), view_(view), room_(room), light_map_(std::move(light_map)) {
  window_ = {view.width(), view.height(), 0, 0};
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    objects_.emplace_back(world.workbench, world.objects[i], first_index + i, look.appearance,
                          look.light);
    const PixelBox& box = boxes_.emplace_back(covered(view, objects_.back().bounds_W()));
    window_ = {std::min(window_.left, box.left), std::min(window_.top, box.top),
               std::max(window_.right, box.right), std::max(window_.bottom, box.bottom)};
  }
  if (window_.right <= window_.left || window_.bottom <= window_.top) window_ = {};
  const std::size_t pixels = place(window_.left, window_.bottom);
  owners_.assign(pixels, kNobody);
  hits_.assign(pixels, {});
  points_.resize(pixels);
  for (std::size_t i = 0; i < objects_.size(); ++i) trace(i);
  for (const PixelBox& box : boxes_) {
    for (int y = box.top; y < box.bottom; ++y) {
      for (int x = box.left; x < box.right; ++x) {
        const std::size_t i = place(x, y);
        if (owners_[i] == kNobody || &boxes_[owners_[i] - 1U] != &box) continue;
        points_[i] = objects_[owners_[i] - 1U].surface(
            hits_[i], view_.eye(),
            view_.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
      }
    }
  }
}

void Scene::trace(std::size_t object) {
  constexpr int kAcross = 4;
  constexpr int kDown = kPacket / kAcross;
  const PixelBox& box = boxes_[object];
  for (int top = box.top; top < box.bottom; top += kDown) {
    for (int left = box.left; left < box.right; left += kAcross) {
      alignas(32) int valid[kPacket];
      RTCRay8 rays{};
      for (int lane = 0; lane < kPacket; ++lane) {
        const int x = left + lane % kAcross;
        const int y = top + lane / kAcross;
        valid[lane] = box.contains(x, y) ? -1 : 0;
        view_.setRay(rays, static_cast<std::size_t>(lane),
                     view_.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
      }
      ObjectHit hits[kPacket];
      const unsigned found = objects_[object].trace(valid, rays, hits);
      for (int lane = 0; lane < kPacket; ++lane) {
        if ((found >> lane & 1U) == 0) continue;
        const std::size_t i = place(left + lane % kAcross, top + lane / kAcross);
        if (owners_[i] != kNobody && hits_[i].depth <= hits[lane].depth) continue;
        owners_[i] = static_cast<std::uint8_t>(object + 1);
        hits_[i] = hits[lane];
      }
    }
  }
}

PixelBox Scene::dimmedBox(std::size_t object) const {
  const Eigen::AlignedBox2f& area = objects_[object].dimmed();
  return covered(view_, {Vector3f(area.min().x(), area.min().y(), 0),
                         Vector3f(area.max().x(), area.max().y(), 0)});
}

bool Scene::atEdge(int x, int y) const {
  constexpr std::array<std::array<int, 2>, 4> kNeighbours{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  const bool inside = window_.contains(x, y);
  const std::uint8_t mine = inside ? owner(x, y) : kNobody;
  for (const auto& [dx, dy] : kNeighbours) {
    if (!window_.contains(x + dx, y + dy)) continue;
    const std::uint8_t other = owner(x + dx, y + dy);
    if (other != mine) return true;
    if (mine == kNobody) continue;
    const SurfacePoint& here = points_[place(x, y)];
    const SurfacePoint& there = points_[place(x + dx, y + dy)];
    if (here.material != there.material || here.normal.dot(there.normal) < 0.6F) return true;
  }
  return false;
}

float Scene::lit(const Vector3f& p_W) const {
  int hidden = 0;
  for (std::size_t set = 0; set < Light::kSets; ++set) {
    unsigned bits = 0;
    for (const PlacedObject& object : objects_) {
      if (object.mayShade(p_W, look_.light)) bits |= object.hides(p_W, look_.light, set);
    }
    hidden += std::popcount(bits);
    // Only where the first set is of two minds is there a penumbra to smooth.
    if (set == 0 && (hidden == 0 || hidden == Light::kSamples)) return hidden == 0 ? 1 : 0;
  }
  return 1 - static_cast<float>(hidden) / (Light::kSets * Light::kSamples);
}

float Scene::lit(const SurfacePoint& point) const {
  // Off the facets, so that a smooth surface does not shade itself.
  constexpr float kOffset_m = 1.2e-3F;
  if (point.normal.dot(look_.light.center() - point.p_W) <= 0) return 0;
  return lit(Vector3f(point.p_W + kOffset_m * point.normal));
}

Vector3f Scene::colorOf(const PlacedObject& object, const SurfacePoint& point, float lit) const {
  return object.shade(point, look_.light, (view_.eye() - point.p_W).normalized(), lit);
}

Vector3f Scene::objectColor(int x, int y) const {
  const std::size_t i = place(x, y);
  return colorOf(objects_[owners_[i] - 1U], points_[i], lit(points_[i]));
}

Vector3f Scene::roomColor(const RoomPoint& point) const {
  return roomColor(point, point.surface == RoomSurface::kTable ? lit(point.p_W) : 1);
}

Vector3f Scene::roomColor(const RoomPoint& point, float lit) const {
  float open = 1;
  if (point.surface == RoomSurface::kTable) {
    for (const PlacedObject& object : objects_) {
      if (object.dimmed().contains(Vector2f(point.p_W.head<2>()))) {
        open *= object.groundOpenness(point.p_W);
      }
    }
  } else if (point.surface != RoomSurface::kNone) {
    lit = light_map_().lit(point);
  }
  return look_.style.shade(room_, look_.light, point, (view_.eye() - point.p_W).normalized(),
                           view_.pixelSize(point.depth), lit, open);
}

Vector3f Scene::blendedColor(int x, int y) const {
  // A rotated grid: no two rays share a row or a column.
  constexpr std::array<std::array<float, 2>, 4> kOffsets{
      {{0.375F, 0.125F}, {0.875F, 0.375F}, {0.125F, 0.625F}, {0.625F, 0.875F}}};
  alignas(32) int valid[kPacket]{-1, -1, -1, -1, 0, 0, 0, 0};
  RTCRay8 rays{};
  std::array<Vector3f, kOffsets.size()> directions;
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    const auto& offset = kOffsets[lane % kOffsets.size()];
    const Vector3f direction =
        view_.direction(static_cast<float>(x) + offset[0], static_cast<float>(y) + offset[1]);
    directions[lane % kOffsets.size()] = direction;
    view_.setRay(rays, lane, direction);
  }
  std::array<const PlacedObject*, kOffsets.size()> seen{};
  std::array<ObjectHit, kOffsets.size()> nearest;
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    if (!boxes_[k].contains(x, y)) continue;
    ObjectHit hits[kPacket];
    const unsigned found = objects_[k].trace(valid, rays, hits);
    for (std::size_t lane = 0; lane < kOffsets.size(); ++lane) {
      if ((found >> lane & 1U) == 0) continue;
      if (seen[lane] != nullptr && nearest[lane].depth <= hits[lane].depth) continue;
      seen[lane] = &objects_[k];
      nearest[lane] = hits[lane];
    }
  }
  bool behind = false;
  for (std::size_t lane = 0; lane < kOffsets.size(); ++lane) {
    if (seen[lane] != nullptr) valid[lane] = 0;
    behind = behind || seen[lane] == nullptr;
  }
  std::array<RoomPoint, kPacket> room_points;
  if (behind) room_.trace(valid, rays, room_points);
  struct Seen {
    const PlacedObject* object;
    Vector3f normal;
    float lit;
  };
  std::array<Seen, kOffsets.size()> known;
  std::size_t kinds = 0;
  const auto litOnce = [&](const PlacedObject* object, const Vector3f& normal, const auto& point) {
    const auto end = known.begin() + static_cast<std::ptrdiff_t>(kinds);
    const auto same = std::find_if(known.begin(), end, [&](const Seen& other) {
      return other.object == object && other.normal.dot(normal) > 0.8F;
    });
    if (same != end) return same->lit;
    known[kinds] = {object, normal, lit(point)};
    return known[kinds++].lit;
  };
  Vector3f sum = Vector3f::Zero();
  for (std::size_t lane = 0; lane < kOffsets.size(); ++lane) {
    Vector3f color;
    if (seen[lane] != nullptr) {
      const SurfacePoint point = seen[lane]->surface(nearest[lane], view_.eye(), directions[lane]);
      color = colorOf(*seen[lane], point, litOnce(seen[lane], point.normal, point));
    } else {
      const RoomPoint& point = room_points[lane];
      const bool table = point.surface == RoomSurface::kTable;
      color = roomColor(point, table ? litOnce(nullptr, Vector3f::UnitZ(), point.p_W) : 1);
    }
    // A highlight may not outweigh the rest of the pixel.
    sum += color.cwiseMin(1.5F);
  }
  return sum / static_cast<float>(kOffsets.size());
}

}  // namespace conceptplan::rendering
