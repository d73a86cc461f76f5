#include "conceptplan/domain/simulation/concept_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace conceptplan {
namespace {

constexpr std::array<Split, 3> kSplits{Split::kTrain, Split::kValidation, Split::kTest};

TEST(ConceptSet, CombinationsAndObjectsAreOneToOne) {
  std::set<ObjectState> objects;
  for (std::size_t i = 0; i < kNumCombinations; ++i) {
    const auto combination = static_cast<CombinationId>(i);
    const ObjectState object = objectOf(combination);
    EXPECT_EQ(combinationOf(object), combination);
    for (const Concept which : kConcepts) {
      EXPECT_GE(valueOf(object, which), 0);
      EXPECT_LT(valueOf(object, which), static_cast<int>(kConceptCardinality[index(which)]));
    }
    objects.insert(object);
  }
  EXPECT_EQ(objects.size(), kNumCombinations);
}

TEST(ConceptSet, EveryCombinationIsInOneSplit) {
  const ConceptSet set(3);
  EXPECT_EQ(set.combinations(Split::kTrain).size(), 4608u);
  EXPECT_EQ(set.combinations(Split::kValidation).size(), 1152u);
  EXPECT_EQ(set.combinations(Split::kTest).size(), 5760u);
  std::set<CombinationId> seen;
  for (const Split split : kSplits) {
    EXPECT_TRUE(std::ranges::is_sorted(set.combinations(split)));
    for (const CombinationId combination : set.combinations(split)) {
      EXPECT_EQ(set.split(combination), split);
      EXPECT_TRUE(seen.insert(combination).second);
    }
  }
}

TEST(ConceptSet, EveryValueOfEveryConceptIsTrainedOn) {
  const ConceptSet set(0);
  std::array<std::set<int>, kNumConcepts> values;
  for (const CombinationId combination : set.combinations(Split::kTrain))
    for (const Concept which : kConcepts)
      values[index(which)].insert(valueOf(objectOf(combination), which));
  for (std::size_t i = 0; i < kNumConcepts; ++i)
    EXPECT_EQ(values[i].size(), kConceptCardinality[i]);
}

TEST(ConceptSet, TheSeedDecidesTheSplits) {
  EXPECT_EQ(ConceptSet(1).combinations(Split::kTest), ConceptSet(1).combinations(Split::kTest));
  EXPECT_NE(ConceptSet(1).combinations(Split::kTest), ConceptSet(2).combinations(Split::kTest));
}

TEST(ConceptSet, PartnersDifferInExactlyThatConcept) {
  const ConceptSet set(0);
  for (const Split split : kSplits) {
    const auto& combinations = set.combinations(split);
    for (std::size_t i = 0; i < combinations.size(); i += 7) {
      const ObjectState anchor = objectOf(combinations[i]);
      for (const Concept which : kConcepts) {
        std::size_t expected = 0;
        for (const CombinationId partner : set.partners(combinations[i], which)) {
          EXPECT_EQ(set.split(partner), split);
          for (const Concept other : kConcepts)
            EXPECT_EQ(valueOf(objectOf(partner), other) != valueOf(anchor, other), other == which);
          ++expected;
        }
        EXPECT_LT(expected, kConceptCardinality[index(which)]);
      }
    }
  }
}

TEST(ConceptSet, PartnersAreAllOfThem) {
  const ConceptSet set(0);
  const CombinationId anchor = set.combinations(Split::kTrain)[100];
  for (const Concept which : kConcepts) {
    std::vector<CombinationId> expected;
    for (const CombinationId other : set.combinations(Split::kTrain)) {
      int differing = 0;
      for (const Concept each : kConcepts)
        differing += valueOf(objectOf(other), each) != valueOf(objectOf(anchor), each);
      if (differing == 1 && valueOf(objectOf(other), which) != valueOf(objectOf(anchor), which))
        expected.push_back(other);
    }
    EXPECT_EQ(set.partners(anchor, which), expected);
  }
}

TEST(ConceptSet, EachPictureHasAnAppearanceOfItsOwn) {
  const ConceptSet set(0);
  std::set<std::uint64_t> seeds;
  for (std::size_t i = 0; i < kNumCombinations; ++i) {
    for (int sample = 0; sample < kNumColorSamples; ++sample) {
      const std::uint64_t seed = set.appearance(static_cast<CombinationId>(i), sample);
      EXPECT_EQ(seed >> 62, 0u);
      seeds.insert(seed);
    }
  }
  EXPECT_EQ(seeds.size(), 230400u);
}

std::uint64_t colorSampleOf(const ConceptSet& set, CombinationId combination, int sample) {
  return set.appearance(combination, sample) % kNumColorSamples;
}

TEST(ConceptSet, ColorSamplesOfTheTrainSplitAreTheFirst) {
  const ConceptSet set(0);
  for (const CombinationId combination : set.combinations(Split::kTrain))
    for (int sample = 0; sample < kNumColorSamples; ++sample)
      EXPECT_EQ(colorSampleOf(set, combination, sample), static_cast<std::uint64_t>(sample));
}

TEST(ConceptSet, FirstSamplesOfTheOtherSplitsShareAllColorSamplesEvenly) {
  const ConceptSet set(0);
  for (const Split split : {Split::kValidation, Split::kTest}) {
    std::array<double, kNumColorSamples> counts{};
    for (const CombinationId combination : set.combinations(split)) {
      const std::uint64_t first = colorSampleOf(set, combination, 0);
      ++counts[first];
      for (int sample = 1; sample < kNumColorSamples; ++sample)
        EXPECT_EQ(colorSampleOf(set, combination, sample),
                  (first + static_cast<std::uint64_t>(sample)) % kNumColorSamples);
    }
    const double even = static_cast<double>(set.combinations(split).size()) / kNumColorSamples;
    for (const double count : counts) EXPECT_NEAR(count, even, 4 * std::sqrt(even)) << name(split);
  }
}

TEST(ConceptSet, WhatIsOutsideTheSetIsABrokenPrecondition) {
  const ConceptSet set(0);
  EXPECT_THROW(objectOf(CombinationId{11520}), std::invalid_argument);
  EXPECT_THROW(set.split(CombinationId{-1}), std::invalid_argument);
  EXPECT_THROW(set.appearance(CombinationId{0}, 20), std::invalid_argument);
  EXPECT_THROW(combinationOf({ObjectType::kPotato, {0, 0}, 0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(combinationOf({ObjectType::kCup, {3, 0}, 0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
