#include "conceptplan/learner/kmeans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

/// Squared distances of every point to every centre: [N, k].
Eigen::MatrixXf squaredDistances(const TokenMatrix& points, const TokenMatrix& centers) {
  Eigen::MatrixXf distances(points.rows(), centers.rows());
  for (Eigen::Index c = 0; c < centers.rows(); ++c)
    distances.col(c) = (points.rowwise() - centers.row(c)).rowwise().squaredNorm();
  return distances;
}

TokenMatrix plusPlusStart(const TokenMatrix& points, Eigen::Index clusters,
                          std::mt19937_64& generator) {
  TokenMatrix centers(clusters, points.cols());
  centers.row(0) = points.row(
      static_cast<Eigen::Index>(generator() % static_cast<std::uint64_t>(points.rows())));
  Eigen::VectorXf nearest = (points.rowwise() - centers.row(0)).rowwise().squaredNorm();
  for (Eigen::Index c = 1; c < clusters; ++c) {
    double draw = static_cast<double>(generator() >> 11) * 0x1.0p-53 * nearest.cast<double>().sum();
    Eigen::Index chosen = 0;
    while (chosen + 1 < points.rows() && (draw -= nearest[chosen]) > 0) ++chosen;
    centers.row(c) = points.row(chosen);
    nearest = nearest.cwiseMin((points.rowwise() - centers.row(c)).rowwise().squaredNorm().eval());
  }
  return centers;
}

KMeansResult lloyd(const TokenMatrix& points, TokenMatrix centers, int max_iterations) {
  const Eigen::Index clusters = centers.rows();
  KMeansResult result;
  double previous = 0;
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const Eigen::MatrixXf distances = squaredDistances(points, centers);
    TokenMatrix sums = TokenMatrix::Zero(clusters, points.cols());
    result.sizes.assign(static_cast<std::size_t>(clusters), 0);
    double total = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      Eigen::Index nearest = 0;
      total += distances.row(i).minCoeff(&nearest);
      sums.row(nearest) += points.row(i);
      ++result.sizes[static_cast<std::size_t>(nearest)];
    }
    for (Eigen::Index c = 0; c < clusters; ++c)
      if (const auto size = result.sizes[static_cast<std::size_t>(c)]; size > 0)
        centers.row(c) = sums.row(c) / static_cast<float>(size);
    result.inertia = total / static_cast<double>(points.rows());
    if (iteration > 0 && previous - result.inertia <= 1e-6 * previous) break;
    previous = result.inertia;
  }
  result.centers = std::move(centers);
  return result;
}

bool hasSmallCluster(const std::vector<std::size_t>& sizes, double least_share) {
  const auto points = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const double least =
      least_share * static_cast<double>(points) / static_cast<double>(sizes.size());
  return std::any_of(sizes.begin(), sizes.end(),
                     [&](std::size_t size) { return static_cast<double>(size) < least; });
}

}  // namespace

TokenMatrix tokensOf(const std::vector<Tokens>& tokens, Concept which) {
  TokenMatrix matrix(static_cast<Eigen::Index>(tokens.size()), TokenMatrix::ColsAtCompileTime);
  for (std::size_t i = 0; i < tokens.size(); ++i)
    matrix.row(static_cast<Eigen::Index>(i)) =
        tokens[i].row(static_cast<Eigen::Index>(index(which)));
  return matrix;
}

ClusterLayout clusterLayout(const TokenMatrix& points, const TokenMatrix& centers) {
  const Eigen::Index clusters = centers.rows();
  if (clusters == 0 || points.rows() == 0)
    throw std::invalid_argument("clusterLayout: " + std::to_string(clusters) + " clusters of " +
                                std::to_string(points.rows()) + " points");
  ClusterLayout layout;
  layout.sizes.assign(static_cast<std::size_t>(clusters), 0);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(clusters);
  // along(a, b): squared offsets of a's points from its centre, along the line to the centre of b
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(clusters, clusters);
  const Eigen::MatrixXf distances = squaredDistances(points, centers);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::Index own = 0;
    const double square = distances.row(i).minCoeff(&own);
    squares[own] += square;
    ++layout.sizes[static_cast<std::size_t>(own)];
    const Eigen::VectorXf offset = (points.row(i) - centers.row(own)).transpose();
    for (Eigen::Index other = 0; other < clusters; ++other) {
      const Eigen::VectorXf line = (centers.row(other) - centers.row(own)).transpose();
      const double length = line.norm();
      if (length > 0) along(own, other) += std::pow(line.dot(offset) / length, 2);
    }
  }
  const auto rootMean = [&](double sum, Eigen::Index cluster) {
    const std::size_t size = layout.sizes[static_cast<std::size_t>(cluster)];
    return size > 0 ? std::sqrt(sum / static_cast<double>(size)) : 0.0;
  };
  for (Eigen::Index c = 0; c < clusters; ++c) layout.spreads.push_back(rootMean(squares[c], c));
  layout.least_separation = std::numeric_limits<double>::infinity();
  for (Eigen::Index a = 0; a < clusters; ++a)
    for (Eigen::Index b = a + 1; b < clusters; ++b) {
      const double distance = (centers.row(a) - centers.row(b)).norm();
      const double deviation = rootMean(along(a, b), a) + rootMean(along(b, a), b);
      const double separation = deviation > 0  ? distance / deviation
                                : distance > 0 ? std::numeric_limits<double>::infinity()
                                               : 0.0;
      if (separation >= layout.least_separation) continue;
      layout.least_separation = separation;
      layout.first = static_cast<std::size_t>(a);
      layout.second = static_cast<std::size_t>(b);
    }
  return layout;
}

std::string doubts(const ClusterLayout& layout, const KMeansOptions& options) {
  std::ostringstream text;
  text.precision(3);
  const auto numberOf = [](const auto& list, auto element) { return element - list.begin(); };
  const std::vector<std::size_t>& sizes = layout.sizes;
  const std::vector<double>& spreads = layout.spreads;
  if (hasSmallCluster(sizes, options.least_share)) {
    const auto smallest = std::min_element(sizes.begin(), sizes.end());
    text << "; cluster " << numberOf(sizes, smallest) << " has " << *smallest << " points of "
         << std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  }
  std::vector<double> sorted = spreads;
  std::sort(sorted.begin(), sorted.end());
  const double median = 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]);
  const auto widest = std::max_element(spreads.begin(), spreads.end());
  if (*widest > options.most_spread * median)
    text << "; cluster " << numberOf(spreads, widest) << " spreads over " << *widest
         << ", the median one over " << median << ": it may hold two values";
  if (layout.least_separation < options.least_separation)
    text << "; clusters " << layout.first << " and " << layout.second << " are "
         << layout.least_separation << " of their deviations apart: they may be one value";
  return text.str().empty() ? "" : text.str().substr(2);
}

KMeansResult kMeans(const TokenMatrix& points, std::size_t clusters, const KMeansOptions& options) {
  if (clusters == 0 || points.rows() < static_cast<Eigen::Index>(clusters))
    throw std::invalid_argument("kMeans: " + std::to_string(clusters) + " clusters of " +
                                std::to_string(points.rows()) + " points");
  std::mt19937_64 generator(options.seed);
  KMeansResult best;
  bool best_has_small = false;
  for (int start = 0; start < std::max(1, options.restarts); ++start) {
    KMeansResult result =
        lloyd(points, plusPlusStart(points, static_cast<Eigen::Index>(clusters), generator),
              options.max_iterations);
    const bool has_small = hasSmallCluster(result.sizes, options.least_share);
    const bool better = best.sizes.empty() || (best_has_small && !has_small) ||
                        (best_has_small == has_small && result.inertia < best.inertia);
    if (!better) continue;
    best = std::move(result);
    best_has_small = has_small;
  }
  best.reason = doubts(clusterLayout(points, best.centers), options);
  best.suspicious = !best.reason.empty();
  return best;
}

}  // namespace conceptplan
