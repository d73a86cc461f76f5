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

Profile thick(float radius) {
  return [radius](float) { return Vector2f(radius, 0); };
}

/// The angle of u turns from +x, in [0, pi].
float awayFromX(float u) { return kPi * std::min(2 * u, 2 - 2 * u); }

}  // namespace

Mesh cupModel() {
  MeshBuilder builder;
  constexpr float kMiddle = -0.027F;
  builder.placement = Translation3f(kMiddle, 0, 0);
  builder.disc(0.040F, 0, plain(kBodyGlazed));
  builder.revolve(
      64, 24,
      spline({{0.039F, 0}, {0.043F, 0.004F}, {0.048F, 0.030F}, {0.052F, 0.065F}, {0.056F, 0.102F}}),
      plain(kBodyGlazed));
  builder.revolve(64, 6, spline({{0.056F, 0.102F}, {0.0545F, 0.106F}, {0.0515F, 0.104F}}),
                  plain(kWhite));
  builder.revolve(64, 10, spline({{0.0515F, 0.104F}, {0.050F, 0.085F}, {0.047F, 0.060F}}),
                  plain(kWhite));
  builder.disc(0.0495F, 0.082F, plain(kCoffee));
  builder.placement.setIdentity();
  builder.tube(spline3({{0.036F, 0, 0.083F},
                        {0.056F, 0, 0.086F},
                        {0.072F, 0, 0.070F},
                        {0.062F, 0, 0.040F},
                        {0.026F, 0, 0.026F}}),
               thick(0.0115F), plain(kWhite), 40);
  return builder.take();
}

Mesh plateModel() {
  MeshBuilder builder;
  // A dark printed sector on the rim towards +x, edged in white.
  const auto print = [](float u, float v) {
    const float angle = awayFromX(u);
    if (v > 0.22F && angle < 0.80F) return kNavy;
    if (v > 0.22F && angle < 0.96F) return kWhite;
    return kBodyGlazed;
  };
  builder.revolve(144, 48,
                  spline({{0, 0.006F},
                          {0.030F, 0.006F},
                          {0.050F, 0.007F},
                          {0.058F, 0.012F},
                          {0.072F, 0.017F},
                          {0.083F, 0.022F}}),
                  print);
  builder.revolve(72, 12,
                  spline({{0.083F, 0.022F},
                          {0.0845F, 0.021F},
                          {0.072F, 0.012F},
                          {0.056F, 0.002F},
                          {0.045F, 0},
                          {0, 0}}),
                  plain(kBodyGlazed));
  return builder.take();
}

Mesh potModel() {
  MeshBuilder builder;
  // A saucepan: long handle to +x, small loop at -x, spout to -y.
  constexpr float kMiddle = -0.022F;
  builder.placement = Translation3f(kMiddle, 0, 0);
  const auto spout = [](float u, float height) {
    const float side = std::remainder(u - 0.75F, 1.0F) * 2 * kPi;
    const float rise = std::clamp((height - 0.045F) / 0.030F, 0.0F, 1.0F);
    return 1 + 0.20F * rise * rise * std::exp(-side * side / 0.05F);
  };
  const auto wall = [&](const Profile& profile) {
    return [&spout, profile](float u, float v) {
      const Vector2f p = profile(v);
      const float r = p.x() * spout(u, p.y());
      return Vector3f(r * std::cos(2 * kPi * u), r * std::sin(2 * kPi * u), p.y());
    };
  };
  builder.disc(0.045F, 0.001F, plain(kBodyGlazed));
  builder.surface(
      96, 20,
      wall(spline({{0.044F, 0.001F}, {0.049F, 0.006F}, {0.050F, 0.040F}, {0.050F, 0.075F}})),
      plain(kBodyGlazed));
  builder.surface(96, 6, wall(spline({{0.050F, 0.075F}, {0.051F, 0.078F}, {0.047F, 0.078F}})),
                  plain(kSteel));
  builder.surface(96, 12, wall(spline({{0.047F, 0.078F}, {0.046F, 0.040F}, {0.044F, 0.012F}})),
                  plain(kSteel));
  builder.disc(0.046F, 0.012F, plain(kSteel));
  builder.placement.setIdentity();
  builder.tube(
      spline3({{0.026F, 0, 0.062F}, {0.045F, 0, 0.067F}, {0.074F, 0, 0.070F}}),
      [](float t) { return Vector2f(0.0085F + 0.0025F * t, 0); }, plain(kBlack));
  builder.tube(spline3({{-0.068F, 0.018F, 0.062F},
                        {-0.0785F, 0.012F, 0.064F},
                        {-0.0785F, -0.012F, 0.064F},
                        {-0.068F, -0.018F, 0.062F}}),
               thick(0.0045F), plain(kSteel));
  return builder.take();
}

Mesh dyerModel() {
  MeshBuilder builder;
  // A pump bottle at the back of a wide tray; the nozzle reaches over a bowl of dye at +x.
  builder.roundedBox({0, 0, 0.006F}, {0.084F, 0.062F, 0.006F}, 0.005F, kWhite);
  builder.placement = Translation3f(-0.040F, 0, 0);
  builder.revolve(56, 28,
                  spline({{0.034F, 0.012F},
                          {0.040F, 0.016F},
                          {0.041F, 0.050F},
                          {0.040F, 0.074F},
                          {0.030F, 0.088F},
                          {0.014F, 0.094F}}),
                  plain(kBodyGlazed));
  builder.revolve(
      40, 8, polyline({{0.017F, 0.090F}, {0.017F, 0.104F}, {0.007F, 0.105F}, {0.007F, 0.122F}}),
      plain(kBlack));
  builder.placement.setIdentity();
  builder.ellipsoid({-0.040F, 0, 0.131F}, {0.021F, 0.019F, 0.012F}, plain(kBlack));
  builder.tube(
      spline3(
          {{-0.036F, 0, 0.133F}, {0.000F, 0, 0.136F}, {0.028F, 0, 0.132F}, {0.036F, 0, 0.112F}}),
      [](float t) { return Vector2f(0.0105F - 0.003F * t, 0); }, plain(kBlack));
  builder.placement = Translation3f(0.040F, 0, 0);
  builder.revolve(56, 8,
                  spline({{0.028F, 0.012F}, {0.036F, 0.018F}, {0.039F, 0.028F}, {0.036F, 0.029F}}),
                  plain(kCharcoal));
  builder.disc(0.0365F, 0.026F, plain(kBodyGlazed));
  return builder.take();
}

Mesh cellphoneModel() {
  MeshBuilder builder;
  // Lying on its screen: a coloured back, dark camera island at +x, pale band at -x.
  builder.roundedBox({0, 0, 0.010F}, {0.084F, 0.043F, 0.010F}, 0.008F, kBodyGlazed);
  builder.roundedBox({0, 0, 0.004F}, {0.0845F, 0.0435F, 0.004F}, 0.003F, kBlack);
  builder.roundedBox({0.050F, 0.012F, 0.020F}, {0.028F, 0.025F, 0.008F}, 0.006F, kBlack);
  for (const auto& [x, y] : {std::pair{0.062F, 0.024F}, {0.062F, 0.000F}, {0.038F, 0.012F}}) {
    builder.placement = Translation3f(x, y, 0);
    builder.revolve(24, 6, polyline({{0.0095F, 0.026F}, {0.0095F, 0.031F}, {0.006F, 0.031F}}),
                    plain(kSteel));
    builder.disc(0.006F, 0.030F, plain(kNavy));
  }
  builder.placement.setIdentity();
  builder.roundedBox({-0.062F, 0, 0.0195F}, {0.006F, 0.030F, 0.0012F}, 0.001F, kWhite);
  return builder.take();
}

Mesh dishSpongeModel() {
  MeshBuilder builder;
  // A sponge with one cut corner and a scouring pad over its half towards +x.
  const auto block = [&builder](float x0, float x1, float z0, float z1, float cut,
                                MaterialId material) {
    const float y = 0.052F;
    const std::array<Vector2f, 5> outline{Vector2f(x0, -y), Vector2f(x1, -y), Vector2f(x1, y - cut),
                                          Vector2f(x1 - cut, y), Vector2f(x0, y)};
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector2f a = outline[i];
      const Vector2f b = outline[(i + 1) % outline.size()];
      builder.surface(
          12, 6,
          [&](float u, float v) {
            const Vector2f p = a + u * (b - a);
            return Vector3f(p.x(), p.y(), z0 + v * (z1 - z0));
          },
          plain(material));
    }
    for (const float z : {z0, z1}) {
      builder.surface(
          24, 24,
          [&](float u, float v) {
            const float px = x0 + u * (x1 - x0);
            const float top = std::min(y, y - cut + (x1 - px));
            return Vector3f(px, -y + v * (top + y), z);
          },
          plain(material));
    }
  };
  block(-0.082F, 0.082F, 0, 0.042F, 0.040F, kBodyMatte);
  block(0.012F, 0.083F, 0.042F, 0.056F, 0.041F, kCharcoal);
  return builder.take();
}

Mesh saltshakerModel() {
  MeshBuilder builder;
  // A dredger: coloured body, steel dome with dark holes, dark handle to +x.
  constexpr float kMiddle = -0.030F;
  builder.placement = Translation3f(kMiddle, 0, 0);
  builder.disc(0.046F, 0, plain(kBodyGlazed));
  const auto label = [](float u, float v) {
    return v > 0.25F && v < 0.75F && std::abs(u - 0.5F) < 0.22F ? kWhite : kBodyGlazed;
  };
  builder.revolve(
      72, 24, spline({{0.044F, 0}, {0.048F, 0.004F}, {0.046F, 0.050F}, {0.043F, 0.098F}}), label);
  const auto holes = [](float u, float v) {
    const bool ring = v > 0.62F && v < 0.78F && std::fmod(u * 6, 1.0F) < 0.45F;
    return ring || v > 0.93F ? kBlack : kSteel;
  };
  builder.revolve(
      72, 30,
      spline({{0.044F, 0.096F}, {0.045F, 0.110F}, {0.040F, 0.126F}, {0.024F, 0.138F}, {0, 0.142F}}),
      holes);
  builder.placement.setIdentity();
  builder.tube(spline3({{0.010F, 0, 0.088F},
                        {0.050F, 0, 0.092F},
                        {0.072F, 0, 0.066F},
                        {0.058F, 0, 0.034F},
                        {0.010F, 0, 0.024F}}),
               thick(0.0115F), plain(kBlack), 40);
  return builder.take();
}

}  // namespace conceptplan::rendering
