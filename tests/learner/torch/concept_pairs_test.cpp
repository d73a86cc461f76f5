#include "conceptplan/learner/torch/concept_pairs.hpp"

#include <gtest/gtest.h>

#include <set>

#include "learner/random_crops.hpp"

namespace conceptplan {
namespace {

constexpr std::int64_t kConceptCount = static_cast<std::int64_t>(kNumConcepts);

/// Pictures of every combination of two values each of TYPE, COLOR and SIZE.
ConceptImages threeConcepts() {
  ConceptImages images;
  for (std::uint8_t code = 0; code < 8; ++code)
    images.add(encoderInput(coloredBlob(code)),
               {static_cast<std::uint8_t>(code & 1U), 0, 0, 0,
                static_cast<std::uint8_t>(code >> 1U & 1U), static_cast<std::uint8_t>(code >> 2U)});
  return images;
}

/// Chains, and what each of their images shows, in the order of the batch.
struct Batch {
  std::vector<ConceptChain> chains;
  std::vector<ConceptValues> shown;
};

Batch drawBatch(const ConceptImages& images, std::size_t count) {
  const ChainSampler sampler(images);
  std::mt19937_64 generator(5);
  Batch batch;
  for (std::size_t i = 0; i < count; ++i) {
    batch.chains.push_back(sampler.draw(generator));
    for (const std::size_t image : batch.chains.back().images)
      batch.shown.push_back(images.values(image));
  }
  return batch;
}

/// The concepts in which two images differ.
std::set<std::int64_t> differences(const ConceptValues& a, const ConceptValues& b) {
  std::set<std::int64_t> differing;
  for (std::size_t k = 0; k < kNumConcepts; ++k)
    if (a[k] != b[k]) differing.insert(static_cast<std::int64_t>(k));
  return differing;
}

/// Tokens and planes that say of which image they are and, tokens, of which concept.
ReadImages numbered(std::int64_t images) {
  const auto number = torch::arange(images).to(torch::kFloat);
  const auto tokens = number.view({-1, 1, 1}) * 10 + torch::arange(kConceptCount).view({1, -1, 1});
  return {number.view({-1, 1, 1, 1}).expand({images, 5, 2, 2}),
          number.view({-1, 1}).expand({images, 3}), number.view({-1, 1, 1, 1}),
          tokens.expand({images, kConceptCount, 64})};
}

TEST(ConceptPairs, DifferInTheConceptThatTheyClaimAlone) {
  const Batch batch = drawBatch(threeConcepts(), 20);
  const ConceptPairs pairs = pairsOf(batch.chains);
  ASSERT_EQ(pairs.first.size(0), 20 * 3);
  for (std::int64_t i = 0; i < pairs.first.size(0); ++i) {
    const auto first = static_cast<std::size_t>(pairs.first[i].item<std::int64_t>());
    const auto second = static_cast<std::size_t>(pairs.second[i].item<std::int64_t>());
    EXPECT_EQ(differences(batch.shown.at(first), batch.shown.at(second)),
              std::set{pairs.differing[i].item<std::int64_t>()});
  }
}

TEST(ConceptPairs, Eq1SubstitutesTheTokenOfTheConceptInWhichThePairDiffers) {
  const Batch batch = drawBatch(threeConcepts(), 4);
  const ReadImages read = numbered(static_cast<std::int64_t>(batch.shown.size()));
  constexpr std::int64_t kCount = 7;
  std::mt19937_64 generator(1);
  const PairsToDraw chosen = choosePairs(pairsOf(batch.chains), read, kCount, generator);
  ASSERT_EQ(chosen.tokens.sizes(), torch::IntArrayRef({2 * kCount, kConceptCount, 64}));
  ASSERT_EQ(chosen.truth.size(0), 2 * kCount);
  for (std::int64_t i = 0; i < kCount; ++i) {
    const auto first = chosen.first[i].item<std::int64_t>();
    const std::int64_t second = first + 1;  // neighbours in a chain
    // The first image is to be drawn from its own tokens, and the second from the substituted ones.
    EXPECT_TRUE(torch::equal(chosen.tokens[i], read.tokens[first]));
    EXPECT_TRUE(torch::equal(chosen.truth[i], read.planes[first]));
    EXPECT_TRUE(torch::equal(chosen.truth[kCount + i], read.planes[second]));
    EXPECT_TRUE(torch::equal(chosen.location[kCount + i], read.location[second]));
    const auto differing = differences(batch.shown.at(static_cast<std::size_t>(first)),
                                       batch.shown.at(static_cast<std::size_t>(second)));
    ASSERT_EQ(differing.size(), 1U);
    for (std::int64_t k = 0; k < kConceptCount; ++k)
      EXPECT_TRUE(torch::equal(chosen.tokens[kCount + i][k],
                               read.tokens[differing.contains(k) ? second : first][k]))
          << "pair " << i << ", concept " << k;
  }
  std::set<std::int64_t> images;
  for (std::int64_t i = 0; i < kCount; ++i) images.insert(chosen.first[i].item<std::int64_t>());
  EXPECT_EQ(images.size(), static_cast<std::size_t>(kCount));  // no pair twice
}

}  // namespace
}  // namespace conceptplan
