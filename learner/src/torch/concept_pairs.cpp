#include "conceptplan/learner/torch/concept_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace conceptplan {

ConceptPairs pairsOf(std::span<const ConceptChain> chains) {
  std::vector<std::int64_t> first, second, differing;
  std::int64_t image = 0;
  for (const ConceptChain& chain : chains) {
    for (std::size_t link = 0; link < kNumConcepts; ++link, ++image) {
      if (!chain.differs[link]) continue;
      first.push_back(image);
      second.push_back(image + 1);
      differing.push_back(static_cast<std::int64_t>(chain.concepts[link]));
    }
    ++image;  // the last one of a chain has no next
  }
  return {torch::tensor(first), torch::tensor(second), torch::tensor(differing)};
}

PairsToDraw choosePairs(const ConceptPairs& pairs, const ReadImages& read, std::int64_t count,
                        std::mt19937_64& generator) {
  std::vector<std::int64_t> order(static_cast<std::size_t>(pairs.first.size(0)));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), generator);
  const auto chosen = torch::tensor(order).slice(0, 0, count);
  const auto first = pairs.first.index({chosen}), second = pairs.second.index({chosen});
  const auto one_hot =
      torch::one_hot(pairs.differing.index({chosen}), static_cast<std::int64_t>(kNumConcepts))
          .to(torch::kBool)
          .unsqueeze(-1);
  const auto substituted =
      torch::where(one_hot, read.tokens.index({second}), read.tokens.index({first}));
  const auto targets = torch::cat({first, second});
  return {first, torch::cat({read.tokens.index({first}), substituted}),
          read.planes.index({targets}), read.location.index({targets})};
}

}  // namespace conceptplan
