#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "conceptplan/learner/tokens.hpp"

namespace conceptplan {

/// The tokens of one concept of each object, in order.
TokenMatrix tokensOf(const std::vector<Tokens>& tokens, Concept which);

struct KMeansOptions {
  int restarts = 12;  ///< starts by k-means++
  int max_iterations = 100;
  double least_share = 0.25;  ///< a cluster smaller than this share of an even one is suspicious
  double most_spread = 2.5;   ///< a cluster this many times as wide as the median one is suspicious
  double least_separation = 3;  ///< two clusters less far apart are suspicious; see `doubts`
  std::uint64_t seed = 0;
};

/// How clusters lie: each point belongs to the nearest centre.
struct ClusterLayout {
  std::vector<std::size_t> sizes;  ///< points of each cluster
  std::vector<double> spreads;     ///< root mean squared distance of its points to its centre
  double least_separation = 0;     ///< of two clusters; infinite for a single one
  std::size_t first = 0;           ///< the two clusters of the least separation
  std::size_t second = 0;
};

/// The separation of two clusters is the distance of their centres over the sum of their standard
/// deviations along the line through both: about 1.3 where a normal distribution was cut in two,
/// 1.7 for a uniform one, more by chance where there are few points; 3 where the border between
/// two values is three standard deviations from either.
/// points [N, 64], centers [k, 64]. @throws std::invalid_argument if there are none of either.
ClusterLayout clusterLayout(const TokenMatrix& points, const TokenMatrix& centers);

/// What speaks against clusters being one value each: the smallest if it is (nearly) empty, the
/// widest if it is much wider than the median one, as two values under one centre are, and the two
/// nearest if they are less separated than two values are. Empty if nothing does.
std::string doubts(const ClusterLayout& layout, const KMeansOptions& options = {});

struct KMeansResult {
  TokenMatrix centers;             ///< [k, 64]
  std::vector<std::size_t> sizes;  ///< points of each cluster
  double inertia = 0;              ///< mean squared distance to the nearest centre
  bool suspicious = false;         ///< values may be merged, split or missing, see `reason`
  std::string reason;              ///< `doubts` of the clusters
};

/// Lloyd's algorithm with k-means++ starts. The start with the least inertia is kept, of those
/// whose clusters are all large enough if there is one.
/// Source: Arthur and Vassilvitskii, SODA 2007.
/// @throws std::invalid_argument if there are fewer points than clusters, or no cluster.
KMeansResult kMeans(const TokenMatrix& points, std::size_t clusters,
                    const KMeansOptions& options = {});

}  // namespace conceptplan
