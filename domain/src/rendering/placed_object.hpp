#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "conceptplan/domain/object.hpp"
#include "conceptplan/domain/rendering/appearance.hpp"
#include "conceptplan/domain/workbench.hpp"
#include "rendering/light.hpp"
#include "rendering/object_geometry.hpp"

namespace conceptplan::rendering {

/// Where a ray meets an object, as Embree says it.
struct ObjectHit {
  float depth = 0;
  unsigned triangle = 0;
  float u = 0;
  float v = 0;
};

/// A point of an object's surface, in W.
struct SurfacePoint {
  Eigen::Vector3f p_W;
  Eigen::Vector3f normal;  ///< unit, towards the eye
  Eigen::Vector3f p_M;     ///< in the model's frame at its largest size
  MaterialId material;
  float open;  ///< share of the sky that its own shape leaves open
};

/// One object of a world, ready to be traced.
class PlacedObject {
 public:
  PlacedObject(const Workbench& workbench, const ObjectState& object, std::size_t index,
               const Appearance& appearance, const Light& light);

  const Eigen::AlignedBox3f& bounds_W() const { return box_W_; }
  /// The nearest hits of the valid lanes. The bits of the result are those of the lanes that hit;
  /// the others keep what they are.
  unsigned trace(const int* valid, const RTCRay8& rays, ObjectHit* hits) const;
  SurfacePoint surface(const ObjectHit& hit, const Eigen::Vector3f& origin_W,
                       const Eigen::Vector3f& direction_W) const;
  Eigen::Vector3f shade(const SurfacePoint& point, const Light& light,
                        const Eigen::Vector3f& to_eye, float lit) const;

  /// Whether the object may hide any of the lamp from the point.
  bool mayShade(const Eigen::Vector3f& p_W, const Light& light) const;
  /// The samples of a set of the lamp's that the object hides from the point, as bits.
  unsigned hides(const Eigen::Vector3f& p_W, const Light& light, std::size_t set) const;
  /// The share of the sky that the object leaves open to a point of the table.
  float groundOpenness(const Eigen::Vector3f& p_W) const;
  /// The part of the table on which the object dims anything.
  const Eigen::AlignedBox2f& dimmed() const { return dimmed_; }

 private:
  Eigen::Vector3f turned(const Eigen::Vector3f& v) const;
  Eigen::Vector3f toModel(const Eigen::Vector3f& v_W) const;

  const ObjectGeometry* geometry_;
  Eigen::Vector3f p_W_;
  float scale_;
  float cosine_;
  float sine_;
  Eigen::Vector3f albedo_;
  Eigen::AlignedBox3f box_W_;
  Eigen::AlignedBox2f shadow_;
  Eigen::AlignedBox2f dimmed_;
};

}  // namespace conceptplan::rendering
