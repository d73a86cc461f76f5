#include "rendering/look.hpp"

#include <array>
#include <cmath>

namespace conceptplan::rendering {
namespace {

enum Purpose : std::uint64_t { kCamera = 1, kLight, kStyle, kNoise };

RandomStream draws(const Appearance& appearance, Purpose purpose) {
  return RandomStream({appearance.seed, static_cast<std::uint64_t>(appearance.domain), purpose});
}

Camera shiftedCamera(RandomStream& random) {
  const auto within = [&random](float reach) -> Eigen::Vector3d {
    const float x = uniform(random, -reach, reach);
    const float y = uniform(random, -reach, reach);
    const float z = uniform(random, -reach, reach);
    return {x, y, z};
  };
  const Camera standard = standardCamera();
  const Eigen::Vector3d p_WEye = standard.X_WC.translation();
  // Where the standard axis meets the table.
  const Eigen::Vector3d axis = standard.X_WC.linear().col(2);
  const Eigen::Vector3d p_WTarget = p_WEye - axis * (p_WEye.z() / axis.z());
  const double field = 2 * std::atan(0.5 * standard.height / standard.focal_px);
  const Eigen::Vector3d eye = p_WEye + within(0.04F);
  const Eigen::Vector3d target = p_WTarget + within(0.02F);
  return lookAt(eye, target, field * uniform(random, 0.98F, 1.02F));
}

float noiseSigma(const Appearance& appearance) {
  if (appearance.domain == RenderDomain::kStandard) return 0;
  RandomStream random = draws(appearance, kNoise);
  return uniform(random, 2, 6);
}

}  // namespace

float LensNoise::at(int x, int y, int channel) const {
  constexpr std::size_t kDraws = 4096;
  static const auto normal = [] {
    std::array<float, kDraws> draws{};
    RandomStream random({kNoise});
    for (std::size_t i = 0; i < kDraws; i += 2) {
      const float radius = std::sqrt(-2 * std::log(1 - uniform(random, 0, 1)));
      const float angle = uniform(random, 0, static_cast<float>(2 * M_PI));
      draws[i] = radius * std::cos(angle);
      draws[i + 1] = radius * std::sin(angle);
    }
    return draws;
  }();
  std::uint64_t h =
      seed_ ^ (static_cast<std::uint64_t>(3 * (y * 4096 + x) + channel) * 0x9E3779B97F4A7C15ULL);
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9ULL;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBULL;
  return sigma_ * normal[(h >> 40) % kDraws];
}

Look::Look(const Appearance& from)
    : Look(from, draws(from, kCamera), draws(from, kLight), draws(from, kStyle)) {}

Look::Look(const Appearance& from, RandomStream&& camera_draws, RandomStream&& light_draws,
           RandomStream&& style_draws)
    : appearance(from),
      camera(from.domain == RenderDomain::kStandard ? standardCamera()
                                                    : shiftedCamera(camera_draws)),
      light(light_draws, from.domain),
      style(style_draws, from.domain),
      noise(stableHash({from.seed, kNoise}), noiseSigma(from)) {
  light.setTableColor(style.tableColor());
}

}  // namespace conceptplan::rendering
