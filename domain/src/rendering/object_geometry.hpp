#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "conceptplan/domain/object.hpp"
#include "rendering/mesh.hpp"
#include "rendering/triangle_scene.hpp"

namespace conceptplan::rendering {

/// Where the object on z = 0 hides the sky from the table around it: a grid over
/// [-kReach, kReach] squared about the object's axis.
class GroundOcclusion {
 public:
  static constexpr int kEdge = 40;
  static constexpr float kReach_m = 0.19F;

  explicit GroundOcclusion(const TriangleScene& scene);
  /// The share of the sky that is open at a point of the table, in [0, 1]; 1 beyond the grid.
  float openness(float x, float y) const;

 private:
  std::vector<float> openness_;
};

/// All that rays need of one object type; immutable.
struct ObjectGeometry {
  explicit ObjectGeometry(Mesh model);

  Mesh mesh;
  TriangleScene scene;
  Eigen::AlignedBox3f bounds;
  std::vector<float> openness;  ///< of each vertex: its share of open hemisphere, in [0, 1]
  GroundOcclusion ground;
};

/// The geometry of a type, built at the first call. Thread-safe.
const ObjectGeometry& objectGeometry(ObjectType type);

}  // namespace conceptplan::rendering
