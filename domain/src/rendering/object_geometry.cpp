#include "rendering/object_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "rendering/object_models.hpp"

namespace conceptplan::rendering {
namespace {

using Eigen::Vector3f;

/// Half of the directions that openness is sampled by.
constexpr int kDirections = 32;

/// Directions over the sphere, even (a Fibonacci lattice).
const std::array<Vector3f, 2 * kDirections>& sphereDirections() {
  static const auto directions = [] {
    std::array<Vector3f, 2 * kDirections> all;
    for (int i = 0; i < 2 * kDirections; ++i) {
      const float z = 1 - (static_cast<float>(i) + 0.5F) / kDirections;
      const float radius = std::sqrt(1 - z * z);
      const float angle = 2.3999632F * static_cast<float>(i);
      all[static_cast<std::size_t>(i)] = {radius * std::cos(angle), radius * std::sin(angle), z};
    }
    return all;
  }();
  return directions;
}

/// The cosine-weighted share of the hemisphere about the normal from which nothing within
/// `reach` blocks the way; below z = 0 is table, which counts as half open.
float openShare(const TriangleScene& scene, const Vector3f& point, const Vector3f& normal,
                float reach) {
  std::array<Vector3f, 2 * kDirections> facing;
  const auto& all = sphereDirections();
  const std::size_t count =
      static_cast<std::size_t>(std::copy_if(all.begin(), all.end(), facing.begin(),
                                            [&](const Vector3f& d) { return d.dot(normal) > 0; }) -
                               facing.begin());
  float open = 0;
  float total = 0;
  for (std::size_t first = 0; first < count; first += kPacket) {
    const std::size_t lanes = std::min<std::size_t>(kPacket, count - first);
    alignas(32) int valid[kPacket]{};
    RTCRay8 rays{};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Vector3f& d = facing[first + lane];
      valid[lane] = -1;
      rays.org_x[lane] = point.x() + 1e-3F * normal.x();
      rays.org_y[lane] = point.y() + 1e-3F * normal.y();
      rays.org_z[lane] = point.z() + 1e-3F * normal.z();
      rays.dir_x[lane] = d.x();
      rays.dir_y[lane] = d.y();
      rays.dir_z[lane] = d.z();
      rays.tnear[lane] = 0;
      rays.tfar[lane] = reach;
      rays.mask[lane] = ~0U;
    }
    scene.occluded(valid, rays);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Vector3f& d = facing[first + lane];
      const float weight = d.dot(normal);
      total += weight;
      if (rays.tfar[lane] < 0) continue;
      const bool meets_table = d.z() < 0 && point.z() < -d.z() * reach;
      open += (meets_table ? 0.5F : 1.0F) * weight;
    }
  }
  return total > 0 ? open / total : 1.0F;
}

}  // namespace

GroundOcclusion::GroundOcclusion(const TriangleScene& scene) : openness_(kEdge * kEdge) {
  for (int j = 0; j < kEdge; ++j) {
    for (int i = 0; i < kEdge; ++i) {
      const auto place = [](int k) {
        return (2 * static_cast<float>(k) / (kEdge - 1) - 1) * kReach_m;
      };
      openness_[static_cast<std::size_t>(j * kEdge + i)] = openShare(
          scene, {place(i), place(j), 0}, Vector3f::UnitZ(), std::numeric_limits<float>::max());
    }
  }
}

float GroundOcclusion::openness(float x, float y) const {
  const float fx = (x / kReach_m + 1) * 0.5F * (kEdge - 1);
  const float fy = (y / kReach_m + 1) * 0.5F * (kEdge - 1);
  if (!(fx >= 0 && fy >= 0 && fx < kEdge - 1 && fy < kEdge - 1)) return 1;
  const int i = static_cast<int>(fx);
  const int j = static_cast<int>(fy);
  const float sx = fx - static_cast<float>(i);
  const float sy = fy - static_cast<float>(j);
  const float* cell = &openness_[static_cast<std::size_t>(j * kEdge + i)];
  const float near = cell[0] + (cell[1] - cell[0]) * sx;
  const float far = cell[kEdge] + (cell[kEdge + 1] - cell[kEdge]) * sx;
  const float inside = near + (far - near) * sy;
  // The grid's edge is not quite open: fade to 1 there.
  const float edge = std::max(std::abs(x), std::abs(y)) / kReach_m;
  const float fade = std::clamp((edge - 0.7F) / 0.3F, 0.0F, 1.0F);
  return inside + (1 - inside) * fade;
}

ObjectGeometry::ObjectGeometry(Mesh model)
    : mesh(std::move(model)), scene(mesh.positions, mesh.triangles), ground(scene) {
  constexpr float kReach_m = 0.12F;
  openness.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    bounds.extend(mesh.positions[i]);
    const Vector3f& p = mesh.positions[i];
    openness.push_back(std::max(openShare(scene, p, mesh.normals[i], kReach_m),
                                openShare(scene, p, -mesh.normals[i], kReach_m)));
  }
}

const ObjectGeometry& objectGeometry(ObjectType type) {
  static std::array<std::once_flag, kNumObjectTypes> once;
  static std::array<std::optional<ObjectGeometry>, kNumObjectTypes> geometries;
  const auto i = static_cast<std::size_t>(type);
  std::call_once(once.at(i), [&] { geometries[i].emplace(objectModel(type)); });
  return *geometries[i];
}

}  // namespace conceptplan::rendering
