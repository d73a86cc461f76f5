#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace conceptplan::rendering {

enum class TextureKind : std::uint8_t {
  kPlanks,   ///< boards along v
  kButcher,  ///< short staves along v
  kMarble,
  kTerrazzo,
  kConcrete,
  kPlaster,
  kLinen,
  kSquareTile,
  kSubwayTile
};

inline constexpr int kNumTextureKinds = 9;

/// What a texture says of a point; colours are given later.
struct Texel {
  float mix = 0;    ///< between a surface's two colours, in [0, 1]
  float joint = 0;  ///< share of joint or grout, in [0, 1]
};

/// A procedural pattern that repeats over the unit square, with mip levels.
class Texture {
 public:
  explicit Texture(TextureKind kind);

  /// Filtered over a square of edge `footprint` in units of the period.
  Texel sample(float u, float v, float footprint) const;

 private:
  struct Level {
    int edge;
    std::vector<std::uint8_t> data;  ///< [edge, edge, 2]
  };
  static Texel fetch(const Level& level, float u, float v);

  std::vector<Level> levels_;
};

/// The texture of a kind, baked at the first call. Thread-safe.
const Texture& texture(TextureKind kind);

}  // namespace conceptplan::rendering
