#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <unordered_map>
#include <vector>

#include "conceptplan/learner/training/concept_images.hpp"

namespace conceptplan {

/// Seven images, each of which differs from the one before in one concept, so that the first and
/// the last differ in all six. Between any two of them it is known for each concept whether they
/// agree.
struct ConceptChain {
  std::array<std::size_t, 1 + kNumConcepts> images{};
  std::array<std::size_t, kNumConcepts> concepts{};  ///< in which link i + 1 differs from link i
  /// Whether it does; where the set has no such image, another picture of the same combination
  /// stands in its place.
  std::array<bool, kNumConcepts> differs{};
};

/// Draws chains of the paper's pairs, which share images: six pairs from seven pictures.
/// Source: the pairing of Sec. II-A of arXiv 2310.03325.
class ChainSampler {
 public:
  /// Keeps a reference to `images`.
  explicit ChainSampler(const ConceptImages& images);

  ConceptChain draw(std::mt19937_64& generator) const;

 private:
  std::size_t drawImage(const ConceptValues& values, std::mt19937_64& generator) const;

  const ConceptImages& images_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> by_combination_;
};

}  // namespace conceptplan
