#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "conceptplan/domain/camera.hpp"
#include "conceptplan/domain/world.hpp"
#include "rendering/look.hpp"
#include "rendering/placed_object.hpp"
#include "rendering/room.hpp"

namespace conceptplan::rendering {

/// A camera in single precision, with rays whose parameter is the depth along its axis.
class View {
 public:
  explicit View(const Camera& camera);

  int width() const { return width_; }
  int height() const { return height_; }
  const Eigen::Vector3f& eye() const { return eye_; }
  Eigen::Vector3f direction(float x, float y) const {
    return axes_ * Eigen::Vector3f((x - center_.x()) / focal_, (y - center_.y()) / focal_, 1);
  }
  void setRay(RTCRay8& rays, std::size_t lane, const Eigen::Vector3f& direction) const;
  float pixelSize(float depth) const { return depth / focal_; }
  /// Where a point appears, in pixels.
  Eigen::Vector2f project(const Eigen::Vector3f& p_W) const;

 private:
  Eigen::Matrix3f axes_;
  Eigen::Vector3f eye_;
  Eigen::Vector2f center_;
  float focal_;
  int width_;
  int height_;
};

/// A rectangle of pixels.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom exclusive

  bool contains(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
};

/// The objects of a world before a camera: which one each pixel sees, and in what colour.
class Scene {
 public:
  /// Light on floor and wall, made when it is first needed.
  using LightMap = std::function<RoomLightMap&()>;
  static constexpr std::uint8_t kNobody = 0;

  /// Traces all pixel centres that may see an object. The references must outlive the scene.
  Scene(const World& world, const Look& look, const View& view, const Room& room,
        LightMap light_map, std::size_t first_index = 0);

  const std::vector<PlacedObject>& objects() const { return objects_; }
  /// The pixels that may see the object, and a border of one.
  const PixelBox& box(std::size_t object) const { return boxes_[object]; }
  /// The pixels whose piece of table the object may dim.
  PixelBox dimmedBox(std::size_t object) const;

  /// 0, or 1 + the index of the object that the pixel's centre sees.
  std::uint8_t owner(int x, int y) const { return owners_[place(x, y)]; }
  float depth(int x, int y) const { return hits_[place(x, y)].depth; }
  /// Whether the pixel or a neighbour of it lies at an outline, a crease or a change of material.
  bool atEdge(int x, int y) const;

  /// Linear colour of an object's pixel by its centre. @pre owner(x, y) is an object
  Eigen::Vector3f objectColor(int x, int y) const;
  /// Linear colour of a point of the room with the objects' shadows.
  Eigen::Vector3f roomColor(const RoomPoint& point) const;
  /// Linear colour of a pixel by the mean of four rays. Those that meet the same side of the same
  /// thing share one look at the lamp.
  Eigen::Vector3f blendedColor(int x, int y) const;

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - window_.top) *
               static_cast<std::size_t>(window_.right - window_.left) +
           static_cast<std::size_t>(x - window_.left);
  }
  void trace(std::size_t object);
  /// The share of the lamp that a point sees past the objects, in [0, 1].
  float lit(const Eigen::Vector3f& p_W) const;
  float lit(const SurfacePoint& point) const;
  Eigen::Vector3f colorOf(const PlacedObject& object, const SurfacePoint& point, float lit) const;
  Eigen::Vector3f roomColor(const RoomPoint& point, float lit) const;

  const Look& look_;
  const View& view_;
  const Room& room_;
  LightMap light_map_;
  std::vector<PlacedObject> objects_;
  std::vector<PixelBox> boxes_;
  PixelBox window_;
  std::vector<std::uint8_t> owners_;
  std::vector<ObjectHit> hits_;
  std::vector<SurfacePoint> points_;
};

}  // namespace conceptplan::rendering
