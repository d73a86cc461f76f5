#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace conceptplan::rendering {

/// Rays that are traced together.
inline constexpr int kPacket = 8;

/// An immutable set of triangles that rays can be traced against. Safe to share between threads.
class TriangleScene {
 public:
  TriangleScene(const std::vector<Eigen::Vector3f>& positions,
                const std::vector<std::array<std::uint32_t, 3>>& triangles);

  /// Nearest hits of the lanes whose `valid` is -1.
  void intersect(const int* valid, RTCRayHit8& rays) const;
  /// Sets `tfar` of every lane that hits anything to minus infinity.
  void occluded(const int* valid, RTCRay8& rays) const;

 private:
  struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
};

}  // namespace conceptplan::rendering
