#include "rendering/mesh.hpp"

#include <algorithm>
#include <cmath>

namespace conceptplan::rendering {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = static_cast<float>(M_PI);

/// The point at t in [0, 1] of a Catmull-Rom spline that passes through all points.
template <typename Point>
Point splinePoint(const std::vector<Point>& points, float t) {
  const int last = static_cast<int>(points.size()) - 1;
  const float s = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(last);
  const int i = std::min(static_cast<int>(s), last - 1);
  const float x = s - static_cast<float>(i);
  const Point& b = points[i];
  const Point& c = points[i + 1];
  const Point a = i > 0 ? points[i - 1] : Point(2 * b - c);
  const Point d = i + 1 < last ? points[i + 2] : Point(2 * c - b);
  return 0.5F * ((2 * b) + (c - a) * x + (2 * a - 5 * b + 4 * c - d) * (x * x) +
                 (3 * b - a - 3 * c + d) * (x * x * x));
}

/// Normal by differences; at a pole, that of a point slightly inside.
Vector3f surfaceNormal(const Surface& surface, float u, float v) {
  constexpr float kStep = 2e-3F;
  for (const float inset : {0.0F, 0.01F}) {
    const float v0 = std::clamp(v, inset, 1 - inset);
    const Vector3f du =
        surface(std::min(u + kStep, 1.0F), v0) - surface(std::max(u - kStep, 0.0F), v0);
    const Vector3f dv =
        surface(u, std::min(v0 + kStep, 1.0F)) - surface(u, std::max(v0 - kStep, 0.0F));
    const Vector3f normal = du.cross(dv);
    if (normal.norm() > 1e-3F * du.norm() * dv.norm() && normal.norm() > 1e-12F) {
      return normal.normalized();
    }
  }
  return Vector3f::UnitZ();
}

std::uint32_t latticeHash(int x, int y, int z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 73856093U ^
                    static_cast<std::uint32_t>(y) * 19349663U ^
                    static_cast<std::uint32_t>(z) * 83492791U;
  h = (h ^ (h >> 15)) * 2246822519U;
  h = (h ^ (h >> 13)) * 3266489917U;
  return h ^ (h >> 16);
}

}  // namespace

MaterialMap plain(MaterialId material) {
  return [material](float, float) { return material; };
}

Profile polyline(std::vector<Vector2f> points) {
  return [points = std::move(points)](float t) -> Vector2f {
    const int last = static_cast<int>(points.size()) - 1;
    const float s = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(last);
    const int i = std::min(static_cast<int>(s), last - 1);
    return points[i] + (s - static_cast<float>(i)) * (points[i + 1] - points[i]);
  };
}

Profile spline(std::vector<Vector2f> points) {
  return [points = std::move(points)](float t) { return splinePoint(points, t); };
}

Path spline3(std::vector<Vector3f> points) {
  return [points = std::move(points)](float t) { return splinePoint(points, t); };
}

void MeshBuilder::surface(int nu, int nv, const Surface& surface, const MaterialMap& material) {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  const Eigen::Matrix3f to_normal = placement.linear().inverse().transpose();
  for (int j = 0; j <= nv; ++j) {
    for (int i = 0; i <= nu; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(nu);
      const float v = static_cast<float>(j) / static_cast<float>(nv);
      mesh_.positions.push_back(placement * surface(u, v));
      mesh_.normals.push_back((to_normal * surfaceNormal(surface, u, v)).normalized());
    }
  }
  const auto at = [&](int i, int j) {
    return first + static_cast<std::uint32_t>(j * (nu + 1) + i);
  };
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      const MaterialId here = material((static_cast<float>(i) + 0.5F) / static_cast<float>(nu),
                                       (static_cast<float>(j) + 0.5F) / static_cast<float>(nv));
      mesh_.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh_.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      mesh_.materials.insert(mesh_.materials.end(), 2, here);
    }
  }
}

void MeshBuilder::revolve(int nu, int nv, const Profile& profile, const MaterialMap& material) {
  surface(
      nu, nv,
      [&](float u, float v) {
        const Vector2f p = profile(v);
        return Vector3f(p.x() * std::cos(2 * kPi * u), p.x() * std::sin(2 * kPi * u), p.y());
      },
      material);
}

void MeshBuilder::disc(float radius, float z, const MaterialMap& material) {
  revolve(48, 6, polyline({{0, z}, {radius, z}}), material);
}

void MeshBuilder::ellipsoid(const Vector3f& center, const Vector3f& radii,
                            const MaterialMap& material, int nu, int nv) {
  surface(
      nu, nv,
      [&](float u, float v) {
        const float a = 2 * kPi * u;
        const float b = kPi * v;
        const Vector3f direction(std::cos(a) * std::sin(b), std::sin(a) * std::sin(b),
                                 -std::cos(b));
        return Vector3f(center + radii.cwiseProduct(direction));
      },
      material);
}

void MeshBuilder::tube(const Path& path, const Profile& radius, const MaterialMap& material,
                       int nv) {
  constexpr float kStep = 5e-3F;
  const auto tangent = [&](float t) {
    return Vector3f(path(std::min(t + kStep, 1.0F)) - path(std::max(t - kStep, 0.0F))).normalized();
  };
  surface(
      16, nv,
      [&](float u, float v) {
        const Vector3f along = tangent(v);
        const Vector3f reference =
            std::abs(along.y()) < 0.8F ? Vector3f::UnitY() : Vector3f::UnitX();
        const Vector3f side = along.cross(reference).normalized();
        const Vector3f other = along.cross(side);
        const float a = 2 * kPi * u;
        return Vector3f(path(v) + radius(v).x() * (std::cos(a) * side + std::sin(a) * other));
      },
      material);
  for (const float end : {0.0F, 1.0F}) {
    ellipsoid(path(end), Vector3f::Constant(radius(end).x()), plain(material(0, end)), 16, 10);
  }
}

void MeshBuilder::roundedBox(const Vector3f& center, const Vector3f& half_extent, float radius,
                             MaterialId material) {
  const Vector3f inner = half_extent.array() - radius;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0F, 1.0F}) {
      surface(
          20, 20,
          [&](float u, float v) {
            Vector3f q;
            q[axis] = sign * half_extent[axis];
            q[(axis + 1) % 3] = (2 * u - 1) * half_extent[(axis + 1) % 3];
            q[(axis + 2) % 3] = (2 * v - 1) * half_extent[(axis + 2) % 3];
            const Vector3f core = q.cwiseMax(-inner).cwiseMin(inner);
            return Vector3f(center + core + radius * (q - core).normalized());
          },
          plain(material));
    }
  }
}

float solidNoise(const Vector3f& p) {
  const Vector3f base = p.array().floor();
  const Vector3f f = p - base;
  const Vector3f s = f.array().square() * (3.0F - 2.0F * f.array());
  const Eigen::Vector3i i = base.cast<int>();
  const auto corner = [&](int dx, int dy, int dz) {
    return static_cast<float>(latticeHash(i.x() + dx, i.y() + dy, i.z() + dz) >> 8) * 0x1p-23F - 1;
  };
  const auto mix = [](float a, float b, float t) { return a + (b - a) * t; };
  const auto plane = [&](int dz) {
    return mix(mix(corner(0, 0, dz), corner(1, 0, dz), s.x()),
               mix(corner(0, 1, dz), corner(1, 1, dz), s.x()), s.y());
  };
  return mix(plane(0), plane(1), s.z());
}

}  // namespace conceptplan::rendering
