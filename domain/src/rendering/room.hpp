#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "conceptplan/domain/workbench.hpp"
#include "rendering/light.hpp"
#include "rendering/texture.hpp"
#include "rendering/triangle_scene.hpp"

namespace conceptplan::rendering {

enum class RoomSurface : std::uint8_t {
  kTable,
  kTableEdge,
  kFrame,
  kFloor,
  kWall,
  kSkirting,
  kNone
};

inline constexpr int kNumRoomSurfaces = 6;

/// What a ray meets where no object is.
struct RoomPoint {
  Eigen::Vector3f p_W{0, 0, 0};
  float depth = 0;  ///< the ray's parameter; 0 where nothing is met
  RoomSurface surface = RoomSurface::kNone;
  std::uint8_t axis = 2;  ///< of the normal
};

/// A workbench against a wall: the part of a picture that depends on the workbench alone.
class Room {
 public:
  explicit Room(const Workbench& workbench);

  float wall() const { return layout_.wall; }
  float halfWidth() const { return layout_.half_width; }

  /// What the rays of the valid lanes meet.
  void trace(const int* valid, const RTCRay8& rays, std::array<RoomPoint, kPacket>& points) const;
  /// The share of the lamp that a point of the room sees, in [0, 1].
  float lit(const Eigen::Vector3f& p_W, const Light& light) const;

  struct Layout {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<RoomSurface> surfaces;  ///< of each triangle
    float half_width = 0;               ///< of the table
    float wall = 0;                     ///< y of the wall
  };

 private:
  Layout layout_;
  TriangleScene scene_;
};

/// Light on the room's floor and wall under one lamp: how much of it each point sees, with the
/// workbench in the way. Found where it is asked for; the references must outlive the map.
class RoomLightMap {
 public:
  RoomLightMap(const Room& room, const Light& light);
  float lit(const RoomPoint& point);

 private:
  static constexpr int kColumns = 61;
  static constexpr int kRows = 27;
  using Grid = std::array<float, kColumns * kRows>;
  static constexpr float kUnknown = -1;

  Eigen::Vector3f p_W(RoomSurface surface, int column, int row) const;
  float at(RoomSurface surface, float a, float b);

  const Room* room_;
  const Light* light_;
  Grid floor_;
  Grid wall_;
};

/// The colours and patterns of a room in one appearance.
class RoomStyle {
 public:
  RoomStyle(RandomStream& random, RenderDomain domain);

  /// The mean colour of the table, linear.
  Eigen::Vector3f tableColor() const;

  /// The colour of a point towards the eye, linear.
  /// @param pixel_m edge of a pixel at the point
  Eigen::Vector3f shade(const Room& room, const Light& light, const RoomPoint& point,
                        const Eigen::Vector3f& to_eye, float pixel_m, float lit, float open) const;

 private:
  struct Finish {
    TextureKind kind = TextureKind::kPlaster;
    Eigen::Vector3f first{0, 0, 0};
    Eigen::Vector3f second{0, 0, 0};
    Eigen::Vector3f joint{0, 0, 0};
    Eigen::Vector2f offset{0, 0};
    float period_m = 1;
    bool turned = false;
    float reflectance = 0;
    float shininess = 1;
  };
  Eigen::Vector3f albedo(const Finish& finish, float a, float b, float pixel_m) const;

  Finish table_;
  Finish splash_;
  Finish floor_;
  Finish wall_;
  Eigen::Vector3f frame_;
  Eigen::Vector3f skirting_;
};

}  // namespace conceptplan::rendering
