#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <unordered_map>
#include <vector>

#include "conceptplan/learner/training/concept_images.hpp"

namespace conceptplan {

/// One anchor image and six partners: partner k differs from the anchor in concept k alone.
struct AnchorGroup {
  std::array<std::size_t, 1 + kNumConcepts> images{};  ///< the anchor, then the partners
  /// Whether partner k exists in the set; where not, its place holds another picture of the
  /// anchor's own combination.
  std::array<bool, kNumConcepts> differs{};
};

/// Draws anchor groups. An image encoded once serves six of the paper's pairs.
/// Source: the pairing of Sec. II-A of arXiv 2310.03325.
class AnchorSampler {
 public:
  /// Keeps a reference to `images`.
  explicit AnchorSampler(const ConceptImages& images);

  AnchorGroup draw(std::mt19937_64& generator) const;

 private:
  std::size_t drawImage(const ConceptValues& values, std::mt19937_64& generator) const;

  const ConceptImages& images_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> by_combination_;
};

}  // namespace conceptplan
