#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "conceptplan/domain/concept.hpp"
#include "conceptplan/domain/object.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// A combination of the six concepts' values, in [0, 11520).
enum class CombinationId : std::int32_t {};

constexpr std::size_t index(CombinationId combination) {
  return static_cast<std::size_t>(combination);
}

/// 8 types x 3 columns x 5 rows x 4 quarter turns x 6 colours x 4 sizes.
inline constexpr std::size_t kNumCombinations = 11520;

/// Pictures of a combination, each with a colour sample of its own: 230,400 in all.
inline constexpr int kNumColorSamples = 20;

/// The object of a combination, and back: `combinationOf(objectOf(c)) == c`.
/// @throws std::invalid_argument for a combination or object outside the set.
ObjectState objectOf(CombinationId combination);
CombinationId combinationOf(const ObjectState& object);

/// The value of a concept of an object, in [0, kConceptCardinality) for objects of the set.
int valueOf(const ObjectState& object, Concept which);

/// Which combinations are trained on: 40 % train, 10 % validation, 50 % test, held out whole, all
/// their samples together, by a permutation that the seed decides.
class ConceptSet {
 public:
  explicit ConceptSet(std::uint64_t seed);

  std::uint64_t seed() const { return seed_; }
  Split split(CombinationId combination) const;

  /// The combinations of a split, ascending.
  const std::vector<CombinationId>& combinations(Split split) const;

  /// Those of the same split that differ from a combination in exactly that concept, ascending; may
  /// be empty. An anchor and its six partners make a batch in which each pair differs in one token.
  std::vector<CombinationId> partners(CombinationId combination, Concept which) const;

  /// The appearance seed of a picture. Divided by 20 it leaves its colour sample: `sample` in the
  /// train split; in the others (f + sample) modulo 20 with an f that a hash of the combination
  /// decides, so that one sample a combination already has all colours. Its two highest bits are 0,
  /// as in no task. @pre sample in [0, kNumColorSamples)
  std::uint64_t appearance(CombinationId combination, int sample) const;

 private:
  std::uint64_t seed_;
  std::vector<Split> split_of_;
  std::array<std::vector<CombinationId>, 3> combinations_;
};

}  // namespace conceptplan
