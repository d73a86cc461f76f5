#include <algorithm>
#include <cmath>

#include "rendering/object_models.hpp"

namespace conceptplan::rendering {
namespace {

using Eigen::AngleAxisf;
using Eigen::Translation3f;
using Eigen::Vector2f;
using Eigen::Vector3f;
using enum MaterialId;

constexpr float kPi = static_cast<float>(M_PI);

Vector3f onSphere(float u, float v) {
  const float a = 2 * kPi * u;
  const float b = kPi * v;
  return {std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), -std::cos(b)};
}

/// Outline (y, z) of a slice of bread, closed over [0, 1].
Vector2f sliceOutline(float t) {
  static const Profile outline = spline({{0, 0},
                                         {-0.036F, 0.001F},
                                         {-0.044F, 0.012F},
                                         {-0.045F, 0.042F},
                                         {-0.057F, 0.062F},
                                         {-0.046F, 0.084F},
                                         {0, 0.093F},
                                         {0.046F, 0.084F},
                                         {0.057F, 0.062F},
                                         {0.045F, 0.042F},
                                         {0.044F, 0.012F},
                                         {0.036F, 0.001F},
                                         {0, 0}});
  return outline(t);
}

/// A cut face of bread at x: crumb with a rim of crust.
void addCrumb(MeshBuilder& builder, float x) {
  const Vector2f middle(0, 0.045F);
  builder.surface(
      72, 12,
      [&](float u, float v) {
        const Vector2f p = middle + v * (sliceOutline(u) - middle);
        return Vector3f(x, p.x(), p.y());
      },
      [](float, float v) { return v > 0.9F ? kBodyShade : kCream; });
}

}  // namespace

Mesh breadModel() {
  constexpr float kBack = -0.083F;
  constexpr float kCut = 0.010F;
  MeshBuilder builder;
  // The loaf: its back end is rounded, its top is scored.
  builder.surface(
      72, 40,
      [](float u, float v) {
        const float x = kBack + (kCut - kBack) * v;
        const float inward = std::clamp((x - kBack) / 0.038F, 0.0F, 1.0F);
        const float scale = std::pow(1 - std::pow(1 - inward, 2.8F), 1 / 2.8F);
        const Vector2f middle(0, 0.030F);
        Vector2f p = middle + scale * (sliceOutline(u) - middle);
        p.y() = std::max(p.y(), 0.0F);
        return Vector3f(x, p.x(), p.y());
      },
      [](float u, float v) {
        // Floury scores across the top.
        const bool top = u > 0.36F && u < 0.64F;
        return top && v > 0.30F && v < 0.90F && std::fmod(v, 0.30F) < 0.075F ? kCream : kBodyMatte;
      });
  addCrumb(builder, kCut);
  // A slice that leans on the cut end and shows its crumb upwards.
  constexpr float kThickness = 0.018F;
  builder.placement = Translation3f(0.070F, 0, 0) * AngleAxisf(-46 * kPi / 180, Vector3f::UnitY());
  builder.surface(
      72, 4,
      [](float u, float v) {
        const Vector2f p = sliceOutline(u);
        return Vector3f(kThickness * v, p.x(), p.y());
      },
      plain(kBodyMatte));
  addCrumb(builder, 0);
  addCrumb(builder, kThickness);
  return builder.take();
}

Mesh eggModel() {
  MeshBuilder builder;
  // Lying along x: the pointed end at +x, the blunt third left undyed and speckled.
  builder.surface(
      96, 72,
      [](float u, float v) {
        const float along = -std::cos(kPi * v);
        const float radius = 0.0585F * std::sin(kPi * v) * (1 - 0.20F * along);
        const float a = 2 * kPi * u;
        return Vector3f(0.082F * along, radius * std::cos(a), 0.0605F + radius * std::sin(a));
      },
      [](float u, float v) {
        const float along = -std::cos(kPi * v);
        if (along > -0.22F) return kBodyWaxy;
        const Vector3f p = 7.0F * onSphere(u, v);
        return along < -0.30F && solidNoise(p) < 0.42F ? kWhite : kCharcoal;
      });
  return builder.take();
}

Mesh lettuceModel() {
  MeshBuilder builder;
  // A head lying along x: pale stem end at -x, wavy leaf tips that open at +x.
  builder.placement = Translation3f(0, 0, 0.048F) * AngleAxisf(kPi / 2, Vector3f::UnitY());
  builder.revolve(32, 12,
                  spline({{0, -0.084F},
                          {0.019F, -0.083F},
                          {0.022F, -0.070F},
                          {0.026F, -0.050F},
                          {0.030F, -0.030F}}),
                  plain(kCream));
  builder.placement.setIdentity();
  builder.ellipsoid({0.008F, 0, 0.046F}, {0.060F, 0.040F, 0.040F}, plain(kBodyShade));
  constexpr int kLeaves = 8;
  for (int leaf = 0; leaf < kLeaves; ++leaf) {
    const bool outer = leaf % 2 == 1;
    const float phase = 2.1F * static_cast<float>(leaf);
    const float turn = 2 * kPi * static_cast<float>(leaf) / kLeaves + 0.2F;
    builder.surface(
        48, 40,
        [&](float u, float v) {
          const float across = 2 * u - 1;
          const float side = across * across;
          const float half_angle = 0.16F + 0.62F * std::sin(kPi * std::min(0.75F * v, 0.5F));
          // Waves grow towards the leaf's rim.
          const float rim = std::max(side * v, v * v * v * v);
          const float wave = 0.0075F * rim * std::sin(9 * across + phase) +
                             0.0055F * side * v * std::sin(17 * v + phase);
          const float flare = 0.014F * v * v * v * v;
          const float radius =
              0.020F + 0.028F * std::sin(kPi * 0.62F * v) + (outer ? 0.004F : 0.0F) + flare + wave;
          const float angle = turn + across * half_angle;
          const float length =
              (outer ? 0.128F : 0.146F) - 0.022F * side + 0.005F * std::sin(7 * across + phase) * v;
          return Vector3f(std::min(-0.070F + length * v, 0.084F),
                          std::clamp(1.15F * radius * std::cos(angle), -0.084F, 0.084F),
                          std::max(0.050F + radius * std::sin(angle), 0.001F));
        },
        [outer](float u, float v) {
          const float across = std::abs(2 * u - 1);
          if (v < 0.22F || across < 0.17F * (0.95F - v)) return kCream;
          return outer ? kBodyWaxy : kBodyShade;
        });
  }
  return builder.take();
}

Mesh tomatoModel() {
  MeshBuilder builder;
  // The crown leans towards +x, and the stem lies out over that side.
  builder.placement = Translation3f(-0.010F, 0, 0.0605F) * AngleAxisf(0.50F, Vector3f::UnitY());
  const auto skin = [](float u, float v) {
    const Vector3f d = onSphere(u, v);
    const float polar = std::max(d.z(), 0.0F);
    const float lobes = 1 + 0.035F * (1 - d.z() * d.z()) * std::cos(10 * kPi * u);
    const float dimple = 1 - 0.22F * std::pow(polar, 10.0F);
    return Vector3f(0.070F * lobes * d.x(), 0.070F * lobes * d.y(), 0.057F * dimple * d.z());
  };
  builder.surface(64, 40, skin, plain(kBodyWaxy));
  constexpr int kSepals = 6;
  for (int sepal = 0; sepal < kSepals; ++sepal) {
    const float turn = static_cast<float>(sepal) / kSepals;
    builder.surface(
        10, 20,
        [&](float u, float v) {
          const float reach = 0.30F * v;
          const float half_width = 0.075F * std::sin(kPi * std::min(0.25F + 0.75F * v, 1.0F));
          const float angle = turn + (u - 0.5F) * half_width / std::max(0.10F + v, 0.05F) * 1.6F;
          Vector3f p = skin(angle, 1 - reach);
          p.z() += 0.004F + 0.010F * v * v;
          return p;
        },
        plain(kStemGreen));
  }
  builder.tube(
      spline3({{0, 0, 0.040F}, {0.004F, 0, 0.062F}, {0.027F, 0, 0.079F}, {0.053F, 0, 0.077F}}),
      [](float t) { return Vector2f(0.0085F + 0.003F * t, 0); }, plain(kStemGreen));
  return builder.take();
}

Mesh potatoModel() {
  MeshBuilder builder;
  // Lumpy, cut at +x by a plane that faces up: pale flesh.
  const Vector3f normal = Vector3f(0.74F, 0, 0.67F).normalized();
  constexpr float kCut = 0.043F;
  const auto peel = [](float u, float v) {
    const Vector3f d = onSphere(u, v);
    const float lumps =
        1 + 0.10F * solidNoise(2.1F * d + Vector3f(3, 7, 1)) + 0.03F * solidNoise(5.0F * d);
    return Vector3f(0.079F * lumps * d.x(), 0.054F * lumps * d.y(), 0.048F * lumps * d.z());
  };
  builder.placement = Translation3f(0.0F, 0, 0.049F);
  builder.surface(
      112, 80,
      [&](float u, float v) {
        Vector3f p = peel(u, v);
        p -= std::max(normal.dot(p) - kCut, 0.0F) * normal;
        return p;
      },
      [&](float u, float v) {
        if (normal.dot(peel(u, v)) > kCut) return kCream;
        const Vector3f d = onSphere(u, v);
        return solidNoise(5.5F * d + Vector3f(9, 2, 5)) > 0.62F ? kCharcoal : kBodyMatte;
      });
  return builder.take();
}

Mesh objectModel(ObjectType type) {
  switch (type) {
    case ObjectType::kBread:
      return breadModel();
    case ObjectType::kCup:
      return cupModel();
    case ObjectType::kEgg:
      return eggModel();
    case ObjectType::kLettuce:
      return lettuceModel();
    case ObjectType::kPlate:
      return plateModel();
    case ObjectType::kTomato:
      return tomatoModel();
    case ObjectType::kPot:
      return potModel();
    case ObjectType::kDyer:
      return dyerModel();
    case ObjectType::kCellphone:
      return cellphoneModel();
    case ObjectType::kDishSponge:
      return dishSpongeModel();
    case ObjectType::kSaltshaker:
      return saltshakerModel();
    case ObjectType::kPotato:
      return potatoModel();
  }
  return {};
}

}  // namespace conceptplan::rendering
