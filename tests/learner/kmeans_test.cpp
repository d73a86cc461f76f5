#include "conceptplan/learner/kmeans.hpp"

#include <gmock/gmock.h>

#include <random>
#include <set>

namespace conceptplan {
namespace {

/// `count` points around each of the corners c * 10 of axis c.
TokenMatrix blobs(Eigen::Index clusters, Eigen::Index count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<float> noise(0, 0.3F);
  TokenMatrix points(clusters * count, 64);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index d = 0; d < 64; ++d) points(i, d) = noise(generator);
    points(i, i % clusters) += 10;
  }
  return points;
}

TEST(KMeans, FindsSeparatedClusters) {
  const TokenMatrix points = blobs(8, 60, 3);
  const KMeansResult result = kMeans(points, 8);
  EXPECT_FALSE(result.suspicious);
  EXPECT_THAT(result.sizes, testing::Each(60U));
  EXPECT_LT(result.inertia, 64 * 0.3 * 0.3 * 1.2);
  std::set<Eigen::Index> axes;
  for (Eigen::Index c = 0; c < 8; ++c) {
    Eigen::Index axis = 0;
    result.centers.row(c).maxCoeff(&axis);
    axes.insert(axis);
  }
  EXPECT_EQ(axes.size(), 8U);
}

TEST(KMeans, SaysWhereAClusterIsNearlyEmpty) {
  TokenMatrix points = blobs(2, 100, 4);
  points.row(0).setConstant(100);  // one outlier takes a centre of its own
  EXPECT_TRUE(kMeans(points, 3).suspicious);
}

TEST(KMeans, SameSeedSameCentres) {
  const TokenMatrix points = blobs(5, 40, 5);
  EXPECT_EQ(kMeans(points, 5).centers, kMeans(points, 5).centers);
}

TEST(KMeans, RefusesFewerPointsThanClusters) {
  EXPECT_THAT([] { kMeans(blobs(1, 2, 1), 3); }, testing::ThrowsMessage<std::invalid_argument>(
                                                     testing::HasSubstr("3 clusters of 2 points")));
}

}  // namespace
}  // namespace conceptplan
