#include "rendering/room.hpp"

#include <algorithm>
#include <cmath>

#include "rendering/color.hpp"

namespace conceptplan::rendering {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using enum RoomSurface;

constexpr float kFloor_m = -0.75F;
constexpr float kTableThickness_m = 0.04F;
constexpr float kSplashTop_m = 0.50F;

void addQuad(Room::Layout& layout, const Vector3f& corner, const Vector3f& a, const Vector3f& b,
             RoomSurface surface) {
  const auto first = static_cast<std::uint32_t>(layout.positions.size());
  for (const Vector3f& p :
       {corner, Vector3f(corner + a), Vector3f(corner + b), Vector3f(corner + a + b)}) {
    layout.positions.push_back(p);
  }
  layout.triangles.push_back({first, first + 1, first + 2});
  layout.triangles.push_back({first + 1, first + 3, first + 2});
  layout.surfaces.insert(layout.surfaces.end(), 2, surface);
}

void addBox(Room::Layout& layout, const Vector3f& low, const Vector3f& high, RoomSurface top,
            RoomSurface sides) {
  const Vector3f extent = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3f a = Vector3f::Unit((axis + 1) % 3) * extent[(axis + 1) % 3];
    const Vector3f b = Vector3f::Unit((axis + 2) % 3) * extent[(axis + 2) % 3];
    addQuad(layout, low, a, b, sides);
    addQuad(layout, low + Vector3f::Unit(axis) * extent[axis], a, b, axis == 2 ? top : sides);
  }
}

Room::Layout makeLayout(const Workbench& workbench) {
  const float half_x = 0.5F * static_cast<float>(workbench.columns * workbench.cell_m);
  const float half_y = 0.5F * static_cast<float>(workbench.rows * workbench.cell_m);
  Room::Layout layout;
  layout.half_width = half_x + 0.10F;
  layout.wall = half_y + 0.22F;
  const float x = layout.half_width;
  const float front = -half_y - 0.02F;
  const float back = layout.wall - 0.002F;
  addBox(layout, {-x, front, -kTableThickness_m}, {x, back, 0}, kTable, kTableEdge);
  addBox(layout, {-x + 0.03F, front + 0.03F, -0.14F}, {x - 0.03F, back - 0.03F, -kTableThickness_m},
         kFrame, kFrame);
  for (const float side : {-1.0F, 1.0F}) {
    for (const float y : {front + 0.03F, back - 0.09F}) {
      const float inner = side * (x - 0.09F);
      const float outer = side * (x - 0.03F);
      addBox(layout, {std::min(inner, outer), y, kFloor_m},
             {std::max(inner, outer), y + 0.06F, -0.14F}, kFrame, kFrame);
    }
  }
  constexpr float kFar = 8;
  addQuad(layout, {-kFar, -kFar, kFloor_m}, {2 * kFar, 0, 0}, {0, kFar + layout.wall, 0}, kFloor);
  addQuad(layout, {-kFar, layout.wall, kFloor_m}, {2 * kFar, 0, 0}, {0, 0, kFar}, kWall);
  addBox(layout, {-kFar, layout.wall - 0.015F, kFloor_m}, {kFar, layout.wall, kFloor_m + 0.10F},
         kSkirting, kSkirting);
  return layout;
}

}  // namespace

Room::Room(const Workbench& workbench)
    : layout_(makeLayout(workbench)), scene_(layout_.positions, layout_.triangles) {}

void Room::trace(const int* valid, const RTCRay8& rays,
                 std::array<RoomPoint, kPacket>& points) const {
  RTCRayHit8 query;
  query.ray = rays;
  std::fill_n(query.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
  scene_.intersect(valid, query);
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    RoomPoint& point = points[lane];
    point = RoomPoint{};
    if (valid[lane] == 0 || query.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
    point.depth = query.ray.tfar[lane];
    point.p_W = Vector3f(rays.org_x[lane], rays.org_y[lane], rays.org_z[lane]) +
                point.depth * Vector3f(rays.dir_x[lane], rays.dir_y[lane], rays.dir_z[lane]);
    point.surface = layout_.surfaces[query.hit.primID[lane]];
    const Vector3f normal(query.hit.Ng_x[lane], query.hit.Ng_y[lane], query.hit.Ng_z[lane]);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    point.axis = static_cast<std::uint8_t>(axis);
  }
}

float Room::lit(const Vector3f& p_W, const Light& light) const {
  alignas(32) int valid[kPacket];
  RTCRay8 rays{};
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    const Vector3f d = light.samples(0)[lane] - p_W;
    valid[lane] = -1;
    rays.org_x[lane] = p_W.x();
    rays.org_y[lane] = p_W.y();
    rays.org_z[lane] = p_W.z();
    rays.dir_x[lane] = d.x();
    rays.dir_y[lane] = d.y();
    rays.dir_z[lane] = d.z();
    rays.tnear[lane] = 1e-3F;
    rays.tfar[lane] = 1;
    rays.mask[lane] = ~0U;
  }
  scene_.occluded(valid, rays);
  const auto open = std::count_if(rays.tfar, rays.tfar + kPacket, [](float t) { return t > 0; });
  return static_cast<float>(open) / kPacket;
}

namespace {

constexpr float kLeft_m = -1.5F;
constexpr float kCell_m = 0.05F;

}  // namespace

RoomLightMap::RoomLightMap(const Room& room, const Light& light) : room_(&room), light_(&light) {
  floor_.fill(kUnknown);
  wall_.fill(kUnknown);
}

Vector3f RoomLightMap::p_W(RoomSurface surface, int column, int row) const {
  const float x = kLeft_m + kCell_m * static_cast<float>(column);
  const float away = kCell_m * static_cast<float>(row);
  if (surface == kFloor) return {x, room_->wall() - 0.02F - away, kFloor_m + 0.002F};
  return {x, room_->wall() - 0.005F, kFloor_m + away};
}

float RoomLightMap::at(RoomSurface surface, float a, float b) {
  const float x = std::clamp((a - kLeft_m) / kCell_m, 0.0F, kColumns - 1.001F);
  const float y = std::clamp(b / kCell_m, 0.0F, kRows - 1.001F);
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const float sx = x - static_cast<float>(i);
  const float sy = y - static_cast<float>(j);
  Grid& grid = surface == kFloor ? floor_ : wall_;
  const auto corner = [&](int di, int dj) {
    float& value = grid[static_cast<std::size_t>((j + dj) * kColumns + i + di)];
    if (value == kUnknown) value = room_->lit(p_W(surface, i + di, j + dj), *light_);
    return value;
  };
  const float low = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * sx;
  const float high = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * sx;
  return low + (high - low) * sy;
}

float RoomLightMap::lit(const RoomPoint& point) {
  switch (point.surface) {
    case kFloor:
      return at(kFloor, point.p_W.x(), room_->wall() - 0.02F - point.p_W.y());
    case kWall:
    case kSkirting:
      return at(kWall, point.p_W.x(), point.p_W.z() - kFloor_m);
    case kTable:
    case kTableEdge:
    case kNone:
      return 1;
    case kFrame:
      return 0.15F;
  }
  return 1;
}

RoomStyle::RoomStyle(RandomStream& random, RenderDomain domain) {
  const bool shifted = domain == RenderDomain::kShifted;
  // Two colours and a joint colour, sRGB; the colours keep away from those of the objects.
  struct Palette {
    Vector3f first, second, joint;
  };
  using Palettes = std::array<Palette, 5>;
  static const Palettes kWood{
      {{{0.80F, 0.68F, 0.54F}, {0.68F, 0.54F, 0.40F}, {0.45F, 0.35F, 0.26F}},
       {{0.86F, 0.78F, 0.67F}, {0.76F, 0.66F, 0.54F}, {0.55F, 0.46F, 0.37F}},
       {{0.62F, 0.50F, 0.40F}, {0.50F, 0.39F, 0.31F}, {0.32F, 0.25F, 0.20F}},
       {{0.74F, 0.70F, 0.65F}, {0.62F, 0.57F, 0.52F}, {0.42F, 0.38F, 0.34F}},
       {{0.76F, 0.63F, 0.52F}, {0.60F, 0.47F, 0.38F}, {0.38F, 0.29F, 0.23F}}}};
  static const Palettes kStone{
      {{{0.88F, 0.87F, 0.85F}, {0.66F, 0.65F, 0.64F}, {0.55F, 0.54F, 0.53F}},
       {{0.80F, 0.78F, 0.75F}, {0.64F, 0.61F, 0.58F}, {0.50F, 0.48F, 0.46F}},
       {{0.66F, 0.66F, 0.67F}, {0.52F, 0.52F, 0.54F}, {0.42F, 0.42F, 0.43F}},
       {{0.85F, 0.81F, 0.75F}, {0.70F, 0.65F, 0.58F}, {0.56F, 0.52F, 0.46F}},
       {{0.90F, 0.89F, 0.88F}, {0.76F, 0.76F, 0.77F}, {0.62F, 0.62F, 0.62F}}}};
  static const Palettes kTinted{
      {{{0.62F, 0.67F, 0.70F}, {0.50F, 0.55F, 0.59F}, {0.40F, 0.44F, 0.47F}},
       {{0.66F, 0.69F, 0.62F}, {0.55F, 0.58F, 0.51F}, {0.44F, 0.46F, 0.40F}},
       {{0.46F, 0.43F, 0.41F}, {0.36F, 0.33F, 0.31F}, {0.26F, 0.24F, 0.23F}},
       {{0.73F, 0.62F, 0.57F}, {0.62F, 0.50F, 0.45F}, {0.46F, 0.38F, 0.35F}},
       {{0.55F, 0.55F, 0.56F}, {0.42F, 0.42F, 0.44F}, {0.32F, 0.32F, 0.33F}}}};
  const auto finish = [&](std::initializer_list<TextureKind> kinds, float period) {
    Finish chosen;
    chosen.kind = kinds.begin()[random.below(kinds.size())];
    const bool wooden = chosen.kind == TextureKind::kPlanks || chosen.kind == TextureKind::kButcher;
    const Palettes& palettes = shifted ? kTinted : (wooden ? kWood : kStone);
    const Palette& palette = palettes[random.below(palettes.size())];
    const float brightness = uniform(random, 0.94F, 1.04F);
    chosen.first = linear(brightness * palette.first);
    chosen.second = linear(brightness * palette.second);
    chosen.joint = linear(brightness * palette.joint);
    chosen.offset = {uniform(random, 0, 1), uniform(random, 0, 1)};
    chosen.period_m = period * uniform(random, 0.85F, 1.15F);
    chosen.turned = random.below(2) == 1;
    return chosen;
  };
  table_ = finish({TextureKind::kPlanks, TextureKind::kButcher, TextureKind::kMarble,
                   TextureKind::kTerrazzo, TextureKind::kConcrete, TextureKind::kLinen},
                  1.3F);
  table_.reflectance = table_.kind == TextureKind::kLinen ? 0.0F : uniform(random, 0.01F, 0.035F);
  table_.shininess = uniform(random, 15, 60);
  splash_ = finish({TextureKind::kSquareTile, TextureKind::kSubwayTile, TextureKind::kMarble,
                    TextureKind::kPlaster},
                   1.0F);
  splash_.turned = false;
  splash_.reflectance = 0.03F;
  splash_.shininess = 40;
  floor_ = finish({TextureKind::kPlanks, TextureKind::kSquareTile, TextureKind::kConcrete,
                   TextureKind::kTerrazzo},
                  2.2F);
  wall_ = finish({TextureKind::kPlaster, TextureKind::kConcrete}, 2.0F);
  wall_.second = 0.5F * (wall_.first + wall_.second);
  frame_ = 0.8F * linear(kWood[random.below(kWood.size())].second);
  skirting_ = linear(Vector3f(0.86F, 0.85F, 0.83F));
}

Vector3f RoomStyle::tableColor() const { return 0.6F * table_.first + 0.4F * table_.second; }

Vector3f RoomStyle::albedo(const Finish& finish, float a, float b, float pixel_m) const {
  float u = a / finish.period_m + finish.offset.x();
  float v = b / finish.period_m + finish.offset.y();
  if (finish.turned) std::swap(u, v);
  u -= std::floor(u);
  v -= std::floor(v);
  const Texel texel = texture(finish.kind).sample(u, v, pixel_m / finish.period_m);
  const Vector3f ground = finish.first + texel.mix * (finish.second - finish.first);
  return ground + 0.7F * texel.joint * (finish.joint - ground);
}

Vector3f RoomStyle::shade(const Room& room, const Light& light, const RoomPoint& point,
                          const Vector3f& to_eye, float pixel_m, float lit, float open) const {
  const Vector3f& p = point.p_W;
  Vector3f normal = Vector3f::Unit(point.axis);
  if (normal.dot(to_eye) < 0) normal = -normal;
  const auto near = [](float distance, float reach) { return std::exp(-distance / reach); };
  switch (point.surface) {
    case kTable:
      return light.shade(p, normal, to_eye, albedo(table_, p.x(), p.y(), pixel_m),
                         table_.reflectance, table_.shininess, lit,
                         open * (1 - 0.30F * near(room.wall() - p.y(), 0.07F)));
    case kTableEdge:
      return light.shade(p, normal, to_eye, 0.85F * tableColor(), 0, 1, lit, 0.8F);
    case kFrame:
      return light.shade(p, normal, to_eye, frame_, 0, 1, lit, 0.45F);
    case kFloor: {
      const float beside = std::max(std::abs(p.x()) - room.halfWidth(), 0.0F);
      return light.shade(p, normal, to_eye, albedo(floor_, p.x(), p.y(), pixel_m), 0, 1, lit,
                         open * (1 - 0.45F * near(beside, 0.25F)) *
                             (1 - 0.25F * near(room.wall() - p.y(), 0.12F)));
    }
    case kWall: {
      const bool splash =
          p.z() > -kTableThickness_m && p.z() < kSplashTop_m && std::abs(p.x()) < room.halfWidth();
      const Finish& finish = splash ? splash_ : wall_;
      const float corner = p.z() > 0 && splash ? 1 - 0.35F * near(p.z(), 0.06F)
                                               : 1 - 0.25F * near(p.z() - kFloor_m, 0.15F);
      return light.shade(p, normal, to_eye, albedo(finish, p.x(), p.z(), pixel_m),
                         finish.reflectance, finish.shininess, lit, open * corner);
    }
    case kSkirting:
      return light.shade(p, normal, to_eye, skirting_, 0, 1, lit, 0.85F);
    case kNone:
      return Vector3f::Zero();
  }
  return Vector3f::Zero();
}

}  // namespace conceptplan::rendering
