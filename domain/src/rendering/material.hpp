#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace conceptplan::rendering {

/// What a triangle is made of. `kBody*` take the object's colour.
enum class MaterialId : std::uint8_t {
  kBodyGlazed,  ///< ceramic, enamel
  kBodyMatte,   ///< crust, skin, sponge
  kBodyWaxy,    ///< tomato, egg, leaf
  kBodyShade,   ///< a darker share of the body's colour
  kCream,       ///< crumb, stem, potato flesh
  kWhite,
  kBlack,
  kCharcoal,
  kSteel,
  kStemGreen,
  kCoffee,
  kNavy
};

inline constexpr int kNumMaterials = 12;

struct Material {
  Eigen::Vector3f albedo;   ///< linear; for a body material a factor on the object's colour
  bool body;                ///< whether the object's colour applies
  float reflectance;        ///< at normal incidence, Schlick's F0
  float shininess;          ///< exponent of the highlight
  float grain;              ///< relative amplitude of the albedo's noise
  float grain_scale_per_m;  ///< frequency of that noise
};

const Material& material(MaterialId id);

}  // namespace conceptplan::rendering
