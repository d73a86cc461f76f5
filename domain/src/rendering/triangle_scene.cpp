#include "rendering/triangle_scene.hpp"

#include <stdexcept>
#include <string>

namespace conceptplan::rendering {
namespace {

/// The one device of the process. One build thread: equal scenes on every machine.
RTCDevice device() {
  static const std::shared_ptr<std::remove_pointer_t<RTCDevice>> shared(
      rtcNewDevice("threads=1,set_affinity=0"), [](RTCDevice d) {
        if (d != nullptr) rtcReleaseDevice(d);
      });
  if (shared == nullptr) {
    throw std::runtime_error("Embree cannot start: error " +
                             std::to_string(rtcGetDeviceError(nullptr)));
  }
  return shared.get();
}

}  // namespace

TriangleScene::TriangleScene(const std::vector<Eigen::Vector3f>& positions,
                             const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : scene_(rtcNewScene(device())) {
  const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) vertices[3 * i + axis] = positions[i][axis];
  }
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner)
      indices[3 * i + corner] = triangles[i][corner];
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene_.get());
}

void TriangleScene::intersect(const int* valid, RTCRayHit8& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene_.get(), &context, &rays);
}

void TriangleScene::occluded(const int* valid, RTCRay8& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded8(valid, scene_.get(), &context, &rays);
}

}  // namespace conceptplan::rendering
