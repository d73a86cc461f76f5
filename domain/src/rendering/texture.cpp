#include "rendering/texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>

namespace conceptplan::rendering {
namespace {

constexpr int kEdge = 512;
constexpr float kTurn = static_cast<float>(2 * M_PI);

std::uint32_t hash(int x, int y, int salt) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393U +
                    static_cast<std::uint32_t>(y) * 668265263U +
                    static_cast<std::uint32_t>(salt) * 2246822519U;
  h = (h ^ (h >> 13)) * 1274126177U;
  h = (h ^ (h >> 16)) * 2654435769U;
  return h ^ (h >> 15);
}

/// In [0, 1).
float random(int x, int y, int salt) {
  return static_cast<float>(hash(x, y, salt) >> 8) * 0x1p-24F;
}

int wrap(int i, int period) { return ((i % period) + period) % period; }

/// Value noise in [0, 1] that repeats after (nu, nv) cells over the unit square.
float noise(float u, float v, int nu, int nv, int salt) {
  const float x = u * static_cast<float>(nu);
  const float y = v * static_cast<float>(nv);
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
  const float sx = smooth(x - static_cast<float>(i));
  const float sy = smooth(y - static_cast<float>(j));
  const auto at = [&](int di, int dj) { return random(wrap(i + di, nu), wrap(j + dj, nv), salt); };
  const float low = at(0, 0) + (at(1, 0) - at(0, 0)) * sx;
  const float high = at(0, 1) + (at(1, 1) - at(0, 1)) * sx;
  return low + (high - low) * sy;
}

/// Several octaves of noise in [0, 1].
float turbulence(float u, float v, int nu, int nv, int octaves, int salt) {
  float sum = 0;
  float total = 0;
  float weight = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * noise(u, v, nu << octave, nv << octave, salt + octave);
    total += weight;
    weight *= 0.5F;
  }
  return sum / total;
}

/// 1 within `width` of a border of the unit cell, with a soft edge.
float nearBorder(float cell, float width) {
  const float distance = std::min(cell, 1 - cell);
  return std::clamp(1.5F - distance / width, 0.0F, 1.0F);
}

/// Boards along v: `across` of them over the period, each cut into `along` pieces.
Texel boards(float u, float v, int across, int along, float contrast) {
  const float x = u * static_cast<float>(across);
  const int column = static_cast<int>(x);
  const float y = v * static_cast<float>(along) + random(column, 0, 11);
  const int piece = wrap(static_cast<int>(std::floor(y)), along);
  const float shift = random(column, piece, 12);
  const float bend = 0.02F * turbulence(u, v, 4, 3, 3, 13 + 7 * column);
  const float grain = turbulence(u + bend + shift, v + shift, 96, 4, 3, 14);
  const float rings =
      0.5F + 0.5F * std::sin(kTurn * (7 * u * static_cast<float>(across) / 4 +
                                      3 * turbulence(u + shift, v, 6, 2, 3, 15) + shift));
  Texel texel;
  texel.mix = std::clamp(
      0.25F + contrast * (random(column, piece, 16) - 0.5F) + 0.5F * (grain - 0.3F) + 0.22F * rings,
      0.0F, 1.0F);
  const float seam = 0.0035F;
  texel.joint =
      std::max(nearBorder(x - static_cast<float>(column), seam * static_cast<float>(across)),
               nearBorder(y - std::floor(y), seam * static_cast<float>(along)));
  return texel;
}

Texel tiles(float u, float v, int across, int up, bool bond) {
  const float y = v * static_cast<float>(up);
  const int row = static_cast<int>(y);
  const float x = u * static_cast<float>(across) + (bond && row % 2 == 1 ? 0.5F : 0.0F);
  const int column = wrap(static_cast<int>(std::floor(x)), across);
  Texel texel;
  texel.mix = 0.65F * random(column, row, 21) + 0.35F * turbulence(u, v, 12, 12, 3, 22);
  constexpr float kGrout = 0.007F;
  texel.joint = std::max(nearBorder(x - std::floor(x), kGrout * static_cast<float>(across)),
                         nearBorder(y - static_cast<float>(row), kGrout * static_cast<float>(up)));
  return texel;
}

/// Chips in a ground: the colour of the nearest of scattered points, if it is near.
float chips(float u, float v, int cells, int salt) {
  const float x = u * static_cast<float>(cells);
  const float y = v * static_cast<float>(cells);
  float shade = 0;
  float nearest = 9;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const int i = static_cast<int>(x) + di;
      const int j = static_cast<int>(y) + dj;
      const int wi = wrap(i, cells);
      const int wj = wrap(j, cells);
      const float dx = static_cast<float>(i) + random(wi, wj, salt) - x;
      const float dy = static_cast<float>(j) + random(wi, wj, salt + 1) - y;
      const float radius = 0.15F + 0.35F * random(wi, wj, salt + 2);
      const float distance = std::sqrt(dx * dx + dy * dy) / radius;
      if (distance < nearest) {
        nearest = distance;
        shade = random(wi, wj, salt + 3);
      }
    }
  }
  return nearest < 1 ? 0.25F + 0.75F * shade : 0;
}

Texel pattern(TextureKind kind, float u, float v) {
  switch (kind) {
    case TextureKind::kPlanks:
      return boards(u, v, 8, 1, 0.45F);
    case TextureKind::kButcher:
      return boards(u, v, 20, 3, 0.55F);
    case TextureKind::kMarble: {
      const float warp = turbulence(u, v, 4, 4, 5, 31);
      const float vein =
          std::abs(turbulence(u + 0.25F * warp, v - 0.2F * warp, 3, 3, 5, 41) - 0.5F);
      const float cloud = turbulence(u, v, 5, 5, 4, 51);
      return {std::clamp(0.75F * std::exp(-26 * vein) + 0.55F * (cloud - 0.35F), 0.0F, 1.0F), 0};
    }
    case TextureKind::kTerrazzo:
      return {std::clamp(0.6F * chips(u, v, 56, 61) + 0.5F * chips(u, v, 110, 71), 0.0F, 1.0F), 0};
    case TextureKind::kConcrete:
      return {std::clamp(1.5F * turbulence(u, v, 5, 5, 7, 81) - 0.25F, 0.0F, 1.0F), 0};
    case TextureKind::kPlaster:
      return {std::clamp(0.5F + 1.1F * (turbulence(u, v, 40, 28, 3, 91) - 0.5F), 0.0F, 1.0F), 0};
    case TextureKind::kLinen: {
      const float uneven =
          0.8F * (turbulence(u, v, 8, 200, 2, 101) + turbulence(u, v, 200, 8, 2, 111));
      const float weave = 0.25F * (std::sin(kTurn * 128 * u) + std::sin(kTurn * 128 * v));
      return {std::clamp(0.5F + weave * 0.5F + (uneven - 0.8F), 0.0F, 1.0F), 0};
    }
    case TextureKind::kSquareTile:
      return tiles(u, v, 10, 10, false);
    case TextureKind::kSubwayTile:
      return tiles(u, v, 6, 14, true);
  }
  return {};
}

}  // namespace

Texture::Texture(TextureKind kind) {
  Level base{kEdge, {}};
  base.data.reserve(2 * kEdge * kEdge);
  for (int j = 0; j < kEdge; ++j) {
    for (int i = 0; i < kEdge; ++i) {
      const Texel texel = pattern(kind, (static_cast<float>(i) + 0.5F) / kEdge,
                                  (static_cast<float>(j) + 0.5F) / kEdge);
      base.data.push_back(static_cast<std::uint8_t>(255 * texel.mix + 0.5F));
      base.data.push_back(static_cast<std::uint8_t>(255 * texel.joint + 0.5F));
    }
  }
  levels_.push_back(std::move(base));
  while (levels_.back().edge > 1) {
    const Level& fine = levels_.back();
    Level coarse{fine.edge / 2, {}};
    for (int j = 0; j < coarse.edge; ++j) {
      for (int i = 0; i < coarse.edge; ++i) {
        for (int channel = 0; channel < 2; ++channel) {
          const auto at = [&](int di, int dj) {
            return int{fine.data[static_cast<std::size_t>(
                2 * ((2 * j + dj) * fine.edge + 2 * i + di) + channel)]};
          };
          coarse.data.push_back(
              static_cast<std::uint8_t>((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4));
        }
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

Texel Texture::fetch(const Level& level, float u, float v) {
  const float x = u * static_cast<float>(level.edge) - 0.5F;
  const float y = v * static_cast<float>(level.edge) - 0.5F;
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const float sx = x - static_cast<float>(i);
  const float sy = y - static_cast<float>(j);
  const int last = level.edge - 1;  // edges are powers of two
  const auto at = [&](int di, int dj) {
    return &level.data[static_cast<std::size_t>(
        2 * (((j + dj) & last) * level.edge + ((i + di) & last)))];
  };
  const std::uint8_t* corners[4] = {at(0, 0), at(1, 0), at(0, 1), at(1, 1)};
  const float weights[4] = {(1 - sx) * (1 - sy), sx * (1 - sy), (1 - sx) * sy, sx * sy};
  Texel texel;
  for (int corner = 0; corner < 4; ++corner) {
    texel.mix += weights[corner] * static_cast<float>(corners[corner][0]);
    texel.joint += weights[corner] * static_cast<float>(corners[corner][1]);
  }
  return {texel.mix / 255, texel.joint / 255};
}

Texel Texture::sample(float u, float v, float footprint) const {
  const float level = std::clamp(std::log2(std::max(footprint * kEdge, 1.0F)), 0.0F,
                                 static_cast<float>(levels_.size() - 1));
  const auto fine = static_cast<std::size_t>(level);
  const std::size_t coarse = std::min(fine + 1, levels_.size() - 1);
  const float share = level - static_cast<float>(fine);
  const Texel a = fetch(levels_[fine], u, v);
  if (share == 0) return a;
  const Texel b = fetch(levels_[coarse], u, v);
  return {a.mix + (b.mix - a.mix) * share, a.joint + (b.joint - a.joint) * share};
}

const Texture& texture(TextureKind kind) {
  static std::array<std::once_flag, kNumTextureKinds> once;
  static std::array<std::optional<Texture>, kNumTextureKinds> textures;
  const auto i = static_cast<std::size_t>(kind);
  std::call_once(once.at(i), [&] { textures[i].emplace(kind); });
  return *textures[i];
}

}  // namespace conceptplan::rendering
