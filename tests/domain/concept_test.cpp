#include "conceptplan/domain/concept.hpp"

#include <gtest/gtest.h>

#include <set>

namespace conceptplan {
namespace {

TEST(Concept, NamesAndConceptsAreOneToOne) {
  std::set<std::string_view> names;
  for (const Concept which : kConcepts) {
    EXPECT_EQ(conceptNamed(name(which)), which);
    names.insert(name(which));
  }
  EXPECT_EQ(names.size(), kNumConcepts);
  EXPECT_EQ(conceptNamed("type"), std::nullopt);
}

TEST(Concept, OrderIsThatOfTheTokens) {
  EXPECT_EQ(name(Concept::kType), "TYPE");
  EXPECT_EQ(name(Concept::kPositionX), "POSITION_X");
  EXPECT_EQ(name(Concept::kPositionY), "POSITION_Y");
  EXPECT_EQ(name(Concept::kRotation), "ROTATION");
  EXPECT_EQ(name(Concept::kColor), "COLOR");
  EXPECT_EQ(name(Concept::kSize), "SIZE");
  for (std::size_t i = 0; i < kNumConcepts; ++i) EXPECT_EQ(index(kConcepts[i]), i);
}

/// Source: Sec. II-A of arXiv 2310.03325.
TEST(Concept, CardinalitiesMultiplyToAllCombinations) {
  std::size_t product = 1;
  for (const std::size_t values : kConceptCardinality) product *= values;
  EXPECT_EQ(product, 11520u);
}

}  // namespace
}  // namespace conceptplan
