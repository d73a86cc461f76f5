#include "conceptplan/learner/kmeans.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>

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

/// Points of blobs of those standard deviations and sizes around corners c * 10 of axis c, and the
/// blob that each is of.
struct Blobs {
  TokenMatrix points;
  std::vector<std::size_t> blob;
};

Blobs unevenBlobs(const std::vector<float>& deviations, const std::vector<Eigen::Index>& sizes,
                  std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  Blobs blobs;
  blobs.points.resize(std::accumulate(sizes.begin(), sizes.end(), Eigen::Index{0}), 64);
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < sizes.size(); ++b) {
    std::normal_distribution<float> noise(0, deviations[b]);
    for (Eigen::Index i = 0; i < sizes[b]; ++i, ++row) {
      for (Eigen::Index d = 0; d < 64; ++d) blobs.points(row, d) = noise(generator);
      blobs.points(row, static_cast<Eigen::Index>(b)) += 10;
      blobs.blob.push_back(b);
    }
  }
  return blobs;
}

/// Whether all points of a blob have the same centre, and no other blob has it.
bool matches(const Blobs& blobs, const TokenMatrix& centers) {
  std::set<std::pair<std::size_t, Eigen::Index>> pairs;
  std::set<Eigen::Index> used;
  for (Eigen::Index i = 0; i < blobs.points.rows(); ++i) {
    Eigen::Index nearest = 0;
    (centers.rowwise() - blobs.points.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
    pairs.emplace(blobs.blob[static_cast<std::size_t>(i)], nearest);
    used.insert(nearest);
  }
  const auto clusters = static_cast<std::size_t>(centers.rows());
  return pairs.size() == clusters && used.size() == clusters;
}

TEST(KMeans, SaysWhereTwoBlobsShareACentreAndAnotherIsSplit) {
  const Blobs blobs = unevenBlobs({0.3F, 0.3F, 0.3F}, {100, 100, 100}, 6);
  TokenMatrix centers(3, 64);  // of the first two blobs, and of the halves of the third
  centers.row(0) = blobs.points.topRows(200).colwise().mean();
  const auto third = blobs.points.bottomRows(100);
  std::array<Eigen::Index, 2> sizes{};
  centers.bottomRows(2).setZero();
  for (Eigen::Index i = 0; i < third.rows(); ++i) {
    const std::size_t half = third(i, 7) > 0 ? 1 : 0;
    centers.row(static_cast<Eigen::Index>(1 + half)) += third.row(i);
    ++sizes[half];
  }
  for (std::size_t half = 0; half < 2; ++half)
    centers.row(static_cast<Eigen::Index>(1 + half)) /= static_cast<float>(sizes[half]);
  const ClusterLayout layout = clusterLayout(blobs.points, centers);
  EXPECT_EQ(layout.sizes[0], 200U);
  EXPECT_NEAR(layout.spreads[0], std::sqrt(64 * 0.09 + 50), 0.2);  // 10 / sqrt(2) to either blob
  EXPECT_EQ(layout.first, 1U);
  EXPECT_EQ(layout.second, 2U);
  EXPECT_LT(layout.least_separation, 1.8);
  EXPECT_THAT(doubts(layout), testing::AllOf(testing::HasSubstr("cluster 0 spreads over 7.4"),
                                             testing::HasSubstr("it may hold two values"),
                                             testing::HasSubstr("clusters 1 and 2 are 1."),
                                             testing::HasSubstr("they may be one value")));
}

TEST(KMeans, FlagsWhatMergesBlobsAndNothingElse) {
  int merged = 0, right = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Blobs blobs = unevenBlobs({0.3F, 0.5F, 0.4F, 0.3F, 0.6F}, {60, 90, 120, 60, 80}, seed);
    const KMeansResult result = kMeans(blobs.points, 5, {.restarts = 1, .seed = seed});
    const bool matched = matches(blobs, result.centers);
    EXPECT_EQ(result.suspicious, !matched) << seed << ": " << result.reason;
    EXPECT_EQ(result.suspicious, !result.reason.empty());
    ++(matched ? right : merged);
  }
  EXPECT_GT(merged, 3);
  EXPECT_GT(right, 10);
}

TEST(KMeans, FlagsABlobThatIsBetterSplitThanTwoOthersApart) {
  Blobs blobs = unevenBlobs({0.1F, 0.1F, 0.1F, 0.1F}, {100, 100, 100, 100}, 8);
  std::mt19937_64 generator(9);
  std::normal_distribution<float> noise(0, 4);
  for (Eigen::Index i = 0; i < 400; ++i) {
    if (i < 100) blobs.points(i, 0) -= 10, blobs.points(i, 1) += 8;  // 2 from the second
    if (i >= 300) blobs.points(i, 20) += noise(generator);           // drawn out
  }
  const KMeansResult result = kMeans(blobs.points, 4);
  EXPECT_THAT(result.sizes, testing::Contains(200U));
  EXPECT_TRUE(result.suspicious);
  EXPECT_THAT(result.reason, testing::HasSubstr("they may be one value"));
}

TEST(KMeans, FlagsCentresThatCoincide) {
  const TokenMatrix same = TokenMatrix::Constant(10, 64, 1);
  const KMeansResult result = kMeans(same, 2);
  EXPECT_TRUE(result.suspicious);
  EXPECT_FALSE(kMeans(same, 1).suspicious);
}

TEST(KMeans, ALayoutNeedsPointsAndCentres) {
  EXPECT_THAT(
      [] { clusterLayout(TokenMatrix(0, 64), TokenMatrix::Zero(2, 64)); },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("2 clusters of 0 points")));
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
