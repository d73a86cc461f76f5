#include "conceptplan/learner/training/anchor_sampler.hpp"

#include <stdexcept>

namespace conceptplan {
namespace {

std::uint64_t key(const ConceptValues& values) {
  std::uint64_t code = 0;
  for (const auto value : values) code = code << 8 | value;
  return code;
}

}  // namespace

AnchorSampler::AnchorSampler(const ConceptImages& images) : images_(images) {
  if (images.size() == 0) throw std::invalid_argument("AnchorSampler: no images");
  for (std::size_t i = 0; i < images.size(); ++i)
    by_combination_[key(images.values(i))].push_back(i);
}

AnchorGroup AnchorSampler::draw(std::mt19937_64& generator) const {
  AnchorGroup group;
  group.images[0] = generator() % images_.size();
  const ConceptValues& anchor = images_.values(group.images[0]);
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    std::vector<ConceptValues> candidates;
    for (std::uint8_t value = 0; value < kConceptCardinality[k]; ++value) {
      ConceptValues other = anchor;
      other[k] = value;
      if (value != anchor[k] && by_combination_.contains(key(other))) candidates.push_back(other);
    }
    group.differs[k] = !candidates.empty();
    const ConceptValues& partner =
        candidates.empty() ? anchor : candidates[generator() % candidates.size()];
    group.images[1 + k] = drawImage(partner, generator);
  }
  return group;
}

std::size_t AnchorSampler::drawImage(const ConceptValues& values,
                                     std::mt19937_64& generator) const {
  const auto& images = by_combination_.at(key(values));
  return images[generator() % images.size()];
}

}  // namespace conceptplan
