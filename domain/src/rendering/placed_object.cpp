#include "rendering/placed_object.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/color.hpp"

namespace conceptplan::rendering {

using Eigen::Vector2f;
using Eigen::Vector3f;

PlacedObject::PlacedObject(const Workbench& workbench, const ObjectState& object, std::size_t index,
                           const Appearance& appearance, const Light& light)
    : geometry_(&objectGeometry(object.type)),
      scale_(static_cast<float>(sizeScale(object.size))),
      albedo_(bodyAlbedo(object.color, colorSample(appearance, index))) {
  constexpr std::array<float, 4> kCosine{1, 0, -1, 0};
  cosine_ = kCosine[static_cast<std::size_t>(object.rotation)];
  sine_ = kCosine[static_cast<std::size_t>((object.rotation + 3) % 4)];
  p_W_ << workbench.p_WCell(object.cell).cast<float>(), 0;

  box_W_.extend(Vector3f(p_W_ + scale_ * turned(geometry_->bounds.min())));
  box_W_.extend(Vector3f(p_W_ + scale_ * turned(geometry_->bounds.max())));
  shadow_.extend(Vector2f(box_W_.min().head<2>())).extend(Vector2f(box_W_.max().head<2>()));
  for (std::size_t i = 0; i < Light::kSets * Light::kSamples; ++i) {
    const Vector3f& lamp = light.samples(i % Light::kSets)[i / Light::kSets];
    for (const auto corner :
         {Eigen::AlignedBox3f::TopLeftCeil, Eigen::AlignedBox3f::TopRightCeil,
          Eigen::AlignedBox3f::BottomLeftCeil, Eigen::AlignedBox3f::BottomRightCeil}) {
      const Vector3f p = box_W_.corner(corner);
      const float t = p.z() / (lamp.z() - p.z());
      shadow_.extend(Vector2f((p + t * (p - lamp)).head<2>()));
    }
  }
  const Vector2f reach = Vector2f::Constant(GroundOcclusion::kReach_m * scale_);
  dimmed_ = shadow_;
  dimmed_.extend(Vector2f(p_W_.head<2>() - reach)).extend(Vector2f(p_W_.head<2>() + reach));
}

Vector3f PlacedObject::turned(const Vector3f& v) const {
  return {cosine_ * v.x() - sine_ * v.y(), sine_ * v.x() + cosine_ * v.y(), v.z()};
}

Vector3f PlacedObject::toModel(const Vector3f& v_W) const {
  return Vector3f(cosine_ * v_W.x() + sine_ * v_W.y(), -sine_ * v_W.x() + cosine_ * v_W.y(),
                  v_W.z()) /
         scale_;
}

unsigned PlacedObject::trace(const int* valid, const RTCRay8& rays, ObjectHit* hits) const {
  RTCRayHit8 query;
  query.ray = rays;
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    const Vector3f origin =
        toModel(Vector3f(rays.org_x[lane], rays.org_y[lane], rays.org_z[lane]) - p_W_);
    const Vector3f direction =
        toModel(Vector3f(rays.dir_x[lane], rays.dir_y[lane], rays.dir_z[lane]));
    query.ray.org_x[lane] = origin.x();
    query.ray.org_y[lane] = origin.y();
    query.ray.org_z[lane] = origin.z();
    query.ray.dir_x[lane] = direction.x();
    query.ray.dir_y[lane] = direction.y();
    query.ray.dir_z[lane] = direction.z();
    query.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  }
  geometry_->scene.intersect(valid, query);
  unsigned found = 0;
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    if (valid[lane] == 0 || query.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[lane] = {query.ray.tfar[lane], query.hit.primID[lane], query.hit.u[lane],
                  query.hit.v[lane]};
    found |= 1U << lane;
  }
  return found;
}

SurfacePoint PlacedObject::surface(const ObjectHit& hit, const Vector3f& origin_W,
                                   const Vector3f& direction_W) const {
  const Mesh& mesh = geometry_->mesh;
  const Mesh::Triangle& corners = mesh.triangles[hit.triangle];
  const float w = 1 - hit.u - hit.v;
  SurfacePoint point;
  point.p_W = origin_W + hit.depth * direction_W;
  point.p_M = w * mesh.positions[corners[0]] + hit.u * mesh.positions[corners[1]] +
              hit.v * mesh.positions[corners[2]];
  // Neighbouring corners of a seam may face opposite ways: bring them to the first one's side.
  Vector3f normal = w * mesh.normals[corners[0]];
  const auto add = [&](std::uint32_t corner, float share) {
    const Vector3f& n = mesh.normals[corner];
    normal += (n.dot(mesh.normals[corners[0]]) < 0 ? -share : share) * n;
  };
  add(corners[1], hit.u);
  add(corners[2], hit.v);
  point.normal = turned(normal).normalized();
  if (point.normal.dot(direction_W) > 0) point.normal = -point.normal;
  point.material = mesh.materials[hit.triangle];
  point.open = w * geometry_->openness[corners[0]] + hit.u * geometry_->openness[corners[1]] +
               hit.v * geometry_->openness[corners[2]];
  return point;
}

Vector3f PlacedObject::shade(const SurfacePoint& point, const Light& light, const Vector3f& to_eye,
                             float lit) const {
  const Material& made_of = material(point.material);
  Vector3f albedo = made_of.body ? made_of.albedo.cwiseProduct(albedo_) : made_of.albedo;
  if (made_of.grain > 0) {
    albedo *= 1 + made_of.grain * solidNoise(made_of.grain_scale_per_m * point.p_M);
  }
  return light.shade(point.p_W, point.normal, to_eye, albedo, made_of.reflectance,
                     made_of.shininess, lit, point.open);
}

bool PlacedObject::mayShade(const Vector3f& p_W, const Light& light) const {
  const float top = box_W_.max().z();
  if (p_W.z() > top || !shadow_.contains(Vector2f(p_W.head<2>()))) return false;
  // Up to the object's top, the bundle of rays to the lamp stays within `spread` of its middle.
  const Vector3f to_lamp = light.center() - p_W;
  const float until = (top - p_W.z()) / to_lamp.z();
  const float spread = light.halfEdge() * until + 1e-4F;
  float enter = 0;
  float leave = until;
  for (int axis = 0; axis < 2; ++axis) {
    const float low = box_W_.min()[axis] - spread - p_W[axis];
    const float high = box_W_.max()[axis] + spread - p_W[axis];
    if (std::abs(to_lamp[axis]) < 1e-6F) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const float a = low / to_lamp[axis];
    const float b = high / to_lamp[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

unsigned PlacedObject::hides(const Vector3f& p_W, const Light& light, std::size_t set) const {
  const Vector3f origin = toModel(p_W - p_W_);
  alignas(32) int valid[kPacket];
  RTCRay8 rays{};
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    const Vector3f direction = toModel(light.samples(set)[lane] - p_W);
    valid[lane] = -1;
    rays.org_x[lane] = origin.x();
    rays.org_y[lane] = origin.y();
    rays.org_z[lane] = origin.z();
    rays.dir_x[lane] = direction.x();
    rays.dir_y[lane] = direction.y();
    rays.dir_z[lane] = direction.z();
    rays.tnear[lane] = 0;
    rays.tfar[lane] = 1;
    rays.mask[lane] = ~0U;
  }
  geometry_->scene.occluded(valid, rays);
  unsigned hidden = 0;
  for (unsigned lane = 0; lane < kPacket; ++lane) {
    if (rays.tfar[lane] < 0) hidden |= 1U << lane;
  }
  return hidden;
}

float PlacedObject::groundOpenness(const Vector3f& p_W) const {
  const Vector3f p = toModel(p_W - p_W_);
  return geometry_->ground.openness(p.x(), p.y());
}

}  // namespace conceptplan::rendering
