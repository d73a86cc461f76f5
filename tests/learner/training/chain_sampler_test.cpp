#include "conceptplan/learner/training/chain_sampler.hpp"

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

TEST(ChainSampler, EachLinkDiffersFromTheOneBeforeInItsConceptAlone) {
  std::vector<ConceptValues> all;
  for (std::uint8_t a = 0; a < 2; ++a)
    for (std::uint8_t b = 0; b < 2; ++b)
      for (std::uint8_t c = 0; c < 3; ++c) all.push_back({a, 0, b, c, 0, 0});
  const ConceptImages images = imagesOf(all);
  const ChainSampler sampler(images);
  std::mt19937_64 generator(1);
  for (int draw = 0; draw < 200; ++draw) {
    const ConceptChain chain = sampler.draw(generator);
    EXPECT_THAT(chain.concepts, testing::UnorderedElementsAre(0, 1, 2, 3, 4, 5));
    for (std::size_t link = 0; link < kNumConcepts; ++link) {
      const std::size_t which = chain.concepts[link];
      EXPECT_EQ(chain.differs[link], which == 0 || which == 2 || which == 3);
      const ConceptValues& before = images.values(chain.images[link]);
      const ConceptValues& after = images.values(chain.images[1 + link]);
      for (std::size_t j = 0; j < kNumConcepts; ++j)
        EXPECT_EQ(after[j] != before[j], j == which && chain.differs[link]);
    }
  }
}

TEST(ChainSampler, RefusesAnEmptySet) {
  EXPECT_THROW(ChainSampler(ConceptImages{}), std::invalid_argument);
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
