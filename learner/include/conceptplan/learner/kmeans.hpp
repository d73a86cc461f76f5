#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "conceptplan/learner/tokens.hpp"

namespace conceptplan {

struct KMeansOptions {
  int restarts = 12;  ///< starts by k-means++; the one with the least inertia is kept
  int max_iterations = 100;
  double least_share = 0.25;  ///< a cluster smaller than this share of an even one is suspicious
  std::uint64_t seed = 0;
};

struct KMeansResult {
  TokenMatrix centers;             ///< [k, 64]
  std::vector<std::size_t> sizes;  ///< points of each cluster
  double inertia = 0;              ///< mean squared distance to the nearest centre
  bool suspicious = false;         ///< a cluster is (nearly) empty, so that others may be merged
};

/// Lloyd's algorithm with k-means++ starts. Starts without suspicious clusters are preferred.
/// Source: Arthur and Vassilvitskii, SODA 2007.
/// @throws std::invalid_argument if there are fewer points than clusters, or no cluster.
KMeansResult kMeans(const TokenMatrix& points, std::size_t clusters,
                    const KMeansOptions& options = {});

}  // namespace conceptplan
