#include "conceptplan/learner/training/chain_sampler.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace conceptplan {
namespace {

std::uint64_t key(const ConceptValues& values) {
  std::uint64_t code = 0;
  for (const auto value : values) code = code << 8 | value;
  return code;
}

}  // namespace

ChainSampler::ChainSampler(const ConceptImages& images) : images_(images) {
  if (images.size() == 0) throw std::invalid_argument("ChainSampler: no images");
  for (std::size_t i = 0; i < images.size(); ++i)
    by_combination_[key(images.values(i))].push_back(i);
}

ConceptChain ChainSampler::draw(std::mt19937_64& generator) const {
  ConceptChain chain;
  std::iota(chain.concepts.begin(), chain.concepts.end(), 0);
  std::shuffle(chain.concepts.begin(), chain.concepts.end(), generator);
  chain.images[0] = generator() % images_.size();
  ConceptValues last = images_.values(chain.images[0]);
  for (std::size_t link = 0; link < kNumConcepts; ++link) {
    const std::size_t k = chain.concepts[link];
    std::vector<ConceptValues> candidates;
    for (std::uint8_t value = 0; value < kConceptCardinality[k]; ++value) {
      ConceptValues other = last;
      other[k] = value;
      if (value != last[k] && by_combination_.contains(key(other))) candidates.push_back(other);
    }
    chain.differs[link] = !candidates.empty();
    if (!candidates.empty()) last = candidates[generator() % candidates.size()];
    chain.images[1 + link] = drawImage(last, generator);
  }
  return chain;
}

std::size_t ChainSampler::drawImage(const ConceptValues& values, std::mt19937_64& generator) const {
  const auto& images = by_combination_.at(key(values));
  return images[generator() % images.size()];
}

}  // namespace conceptplan
