#include "conceptplan/learner/training/anchor_sampler.hpp"

#include <gmock/gmock.h>

#include "learner/random_crops.hpp"

namespace conceptplan {
namespace {

ConceptImages imagesOf(const std::vector<ConceptValues>& values) {
  ConceptImages images;
  for (std::size_t i = 0; i < values.size(); ++i)
    images.add(encoderInput(coloredBlob(i)), values[i]);
  return images;
}

TEST(AnchorSampler, PartnerKDiffersInConceptKAlone) {
  std::vector<ConceptValues> all;
  for (std::uint8_t a = 0; a < 2; ++a)
    for (std::uint8_t b = 0; b < 2; ++b)
      for (std::uint8_t c = 0; c < 3; ++c) all.push_back({a, 0, b, c, 0, 0});
  const ConceptImages images = imagesOf(all);
  const AnchorSampler sampler(images);
  std::mt19937_64 generator(1);
  for (int draw = 0; draw < 200; ++draw) {
    const AnchorGroup group = sampler.draw(generator);
    const ConceptValues& anchor = images.values(group.images[0]);
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      const ConceptValues& partner = images.values(group.images[1 + k]);
      for (std::size_t j = 0; j < kNumConcepts; ++j)
        EXPECT_EQ(partner[j] != anchor[j], j == k && group.differs[k]);
    }
    EXPECT_TRUE(group.differs[0]);
    EXPECT_FALSE(group.differs[1]);
    EXPECT_TRUE(group.differs[3]);
  }
}

TEST(AnchorSampler, RefusesAnEmptySet) {
  EXPECT_THROW(AnchorSampler(ConceptImages{}), std::invalid_argument);
}

TEST(ConceptValues, AreThoseOfTheObject) {
  const ObjectState object{ObjectType::kPot, {2, 4}, 3, 5, 1};
  EXPECT_EQ(conceptValues(object), (ConceptValues{6, 2, 4, 3, 5, 1}));
  EXPECT_THAT(
      [] {
        conceptValues({ObjectType::kPotato, {0, 0}, 0, 0, 0});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("Potato")));
}

}  // namespace
}  // namespace conceptplan
