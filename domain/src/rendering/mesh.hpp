#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "rendering/material.hpp"

namespace conceptplan::rendering {

/// A smooth triangle mesh: one normal a vertex, one material a triangle.
struct Mesh {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;  ///< unit; either side
  std::vector<Triangle> triangles;
  std::vector<MaterialId> materials;
};

/// A surface over the unit square; periodic where it closes.
using Surface = std::function<Eigen::Vector3f(float u, float v)>;
using MaterialMap = std::function<MaterialId(float u, float v)>;
/// A plane curve over [0, 1]: (radius, height) of a body of revolution.
using Profile = std::function<Eigen::Vector2f(float)>;
/// A space curve over [0, 1].
using Path = std::function<Eigen::Vector3f(float)>;

MaterialMap plain(MaterialId material);
/// Straight segments through the points.
Profile polyline(std::vector<Eigen::Vector2f> points);
/// A Catmull-Rom spline through the points.
Profile spline(std::vector<Eigen::Vector2f> points);
Path spline3(std::vector<Eigen::Vector3f> points);

/// Assembles a mesh from parametric surfaces. Every surface is placed by `placement`.
class MeshBuilder {
 public:
  Eigen::Affine3f placement = Eigen::Affine3f::Identity();

  /// `nu` x `nv` quads; each takes the material of its centre.
  void surface(int nu, int nv, const Surface& surface, const MaterialMap& material);
  /// A body of revolution about z; u is the angle from +x in turns.
  void revolve(int nu, int nv, const Profile& profile, const MaterialMap& material);
  /// A horizontal disc about (0, 0, z); u is the angle, v the radius.
  void disc(float radius, float z, const MaterialMap& material);
  void ellipsoid(const Eigen::Vector3f& center, const Eigen::Vector3f& radii,
                 const MaterialMap& material, int nu = 40, int nv = 24);
  /// A tube with round ends; v runs along the path.
  void tube(const Path& path, const Profile& radius, const MaterialMap& material, int nv = 32);
  void roundedBox(const Eigen::Vector3f& center, const Eigen::Vector3f& half_extent, float radius,
                  MaterialId material);

  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
};

/// Smooth noise in [-1, 1] of a point; features about one unit wide.
float solidNoise(const Eigen::Vector3f& p);

}  // namespace conceptplan::rendering
