#pragma once

#include <Eigen/Core>
#include <array>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/domain/task.hpp"
#include "rendering/material.hpp"

namespace conceptplan::rendering {

/// Uniform in [low, high).
float uniform(RandomStream& random, float low, float high);

/// A rectangular lamp over the bench, the sky of the room, and the light that the table throws
/// back. Linear RGB; a white horizontal surface under all of it comes out near 1.
class Light {
 public:
  /// Points of the lamp that rays go to together, and the number of such sets.
  static constexpr int kSamples = 8;
  static constexpr int kSets = 2;

  Light(RandomStream& random, RenderDomain domain);

  /// Points spread over the lamp, no two of a set in line along an edge.
  const std::array<Eigen::Vector3f, kSamples>& samples(std::size_t set) const {
    return samples_[set];
  }
  const Eigen::Vector3f& center() const { return center_; }
  float halfEdge() const { return half_edge_; }

  /// The colour of a surface towards the eye.
  /// @param reflectance at normal incidence; 0 for a surface without any gloss
  /// @param lit share of the lamp that is seen, in [0, 1]
  /// @param open share of the sky that is seen, in [0, 1]
  Eigen::Vector3f shade(const Eigen::Vector3f& p_W, const Eigen::Vector3f& normal,
                        const Eigen::Vector3f& to_eye, const Eigen::Vector3f& albedo,
                        float reflectance, float shininess, float lit, float open) const;

  /// The colour of the table as it lights what stands on it.
  void setTableColor(const Eigen::Vector3f& albedo) { bounce_ = 0.55F * albedo; }

 private:
  Eigen::Vector3f surroundings(const Eigen::Vector3f& direction) const;

  Eigen::Vector3f center_;
  std::array<std::array<Eigen::Vector3f, kSamples>, kSets> samples_;
  Eigen::Vector3f lamp_;    ///< irradiance at the middle of the table when facing the lamp
  Eigen::Vector3f sky_;     ///< irradiance from above
  Eigen::Vector3f window_;  ///< irradiance from the side of the camera
  Eigen::Vector3f toward_window_;
  Eigen::Vector3f bounce_ = Eigen::Vector3f::Constant(0.3F);
  float half_edge_ = 0;
  float distance_squared_ = 4;
};

}  // namespace conceptplan::rendering
