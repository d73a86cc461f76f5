#include "conceptplan/learner/kmeans.hpp"

#include <algorithm>
#include <random>
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

}  // namespace

KMeansResult kMeans(const TokenMatrix& points, std::size_t clusters, const KMeansOptions& options) {
  if (clusters == 0 || points.rows() < static_cast<Eigen::Index>(clusters))
    throw std::invalid_argument("kMeans: " + std::to_string(clusters) + " clusters of " +
                                std::to_string(points.rows()) + " points");
  std::mt19937_64 generator(options.seed);
  const double least =
      options.least_share * static_cast<double>(points.rows()) / static_cast<double>(clusters);
  KMeansResult best;
  for (int start = 0; start < std::max(1, options.restarts); ++start) {
    KMeansResult result =
        lloyd(points, plusPlusStart(points, static_cast<Eigen::Index>(clusters), generator),
              options.max_iterations);
    for (const std::size_t size : result.sizes)
      result.suspicious = result.suspicious || static_cast<double>(size) < least;
    const bool better = best.sizes.empty() || (best.suspicious && !result.suspicious) ||
                        (best.suspicious == result.suspicious && result.inertia < best.inertia);
    if (better) best = std::move(result);
  }
  return best;
}

}  // namespace conceptplan
