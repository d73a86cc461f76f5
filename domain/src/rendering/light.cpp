#include "rendering/light.hpp"

#include <algorithm>
#include <cmath>

namespace conceptplan::rendering {

using Eigen::Vector3f;

float uniform(RandomStream& random, float low, float high) {
  constexpr std::size_t kSteps = std::size_t{1} << 24;
  return low + (high - low) * static_cast<float>(random.below(kSteps)) / kSteps;
}

Light::Light(RandomStream& random, RenderDomain domain) {
  const bool shifted = domain == RenderDomain::kShifted;
  const float reach = shifted ? 1.0F : 0.7F;
  center_ = {uniform(random, -reach, reach), uniform(random, -0.9F, shifted ? 0.4F : 0.1F),
             uniform(random, 1.8F, 2.3F)};
  const float edge = uniform(random, 0.45F, 0.65F);
  half_edge_ = 0.5F * edge;
  const float strength = shifted ? uniform(random, 0.7F, 1.25F) : uniform(random, 0.8F, 1.2F);
  const float warmth = shifted ? uniform(random, -0.10F, 0.12F) : uniform(random, -0.02F, 0.05F);
  const float share = uniform(random, 0.63F, 0.75F);
  const Vector3f tint(1 + warmth, 1, 1 - 1.2F * warmth);
  lamp_ = 1.05F * strength * share * tint;
  sky_ = 1.0F * strength * (1 - share) * Vector3f(0.99F, 1, 1.02F);
  window_ = 0.22F * strength * Vector3f(0.98F, 1, 1.03F);
  toward_window_ = Vector3f(uniform(random, -0.8F, 0.8F), -1, 0.25F).normalized();
  constexpr std::array<int, kSamples> kColumns{2, 5, 0, 7, 3, 6, 1, 4};
  for (std::size_t set = 0; set < kSets; ++set) {
    for (std::size_t i = 0; i < kSamples; ++i) {
      const float inset = set == 0 ? 0.25F : 0.75F;
      const float x = (static_cast<float>(kColumns[i]) + inset) / kSamples - 0.5F;
      const float y = (static_cast<float>(i) + 1 - inset) / kSamples - 0.5F;
      samples_[set][i] = center_ + edge * Vector3f(x, y, 0);
    }
  }
  distance_squared_ = center_.squaredNorm();
}

Vector3f Light::surroundings(const Vector3f& direction) const {
  if (direction.z() < 0) return bounce_;
  const Vector3f wall = 0.8F * sky_;
  const Vector3f ceiling = 2.2F * sky_;
  const float panel = std::max(direction.dot(toward_window_), 0.0F);
  return wall + (ceiling - wall) * direction.z() + 3 * panel * panel * panel * panel * window_;
}

Vector3f Light::shade(const Vector3f& p_W, const Vector3f& normal, const Vector3f& to_eye,
                      const Vector3f& albedo, float reflectance, float shininess, float lit,
                      float open) const {
  const Vector3f offset = center_ - p_W;
  const float distance_squared = offset.squaredNorm();
  const Vector3f to_lamp = offset / std::sqrt(distance_squared);
  const Vector3f lamp = lamp_ * (distance_squared_ / distance_squared);
  const float facing = std::max(normal.dot(to_lamp), 0.0F) * lit;
  const float up = 0.5F + 0.5F * normal.z();
  const Vector3f ambient = bounce_.cwiseProduct(sky_ + lamp_) * (1 - up) + sky_ * up +
                           window_ * std::max(normal.dot(toward_window_), 0.0F);
  const Vector3f diffuse = albedo.cwiseProduct(lamp * facing + ambient * open);
  if (reflectance == 0) return diffuse;

  const float cosine = std::clamp(normal.dot(to_eye), 0.0F, 1.0F);
  const float grazing = 1 - cosine;
  const float gloss = std::min(shininess / 100, 1.0F);
  const float fresnel = reflectance + (1 - reflectance) * gloss * 0.5F * grazing * grazing *
                                          grazing * grazing * grazing;
  const Vector3f mirrored = 2 * normal.dot(to_eye) * normal - to_eye;
  const Vector3f half = (to_lamp + to_eye).normalized();
  const float lobe =
      facing > 0 ? (shininess + 8) / 25 * std::pow(std::max(normal.dot(half), 0.0F), shininess) : 0;
  return diffuse + fresnel * (lamp * (lobe * facing) + gloss * open * surroundings(mirrored));
}

}  // namespace conceptplan::rendering
