#include "conceptplan/domain/simulation/concept_set.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "conceptplan/domain/simulation/random_stream.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kNumTrain = kNumCombinations * 4 / 10;
constexpr std::size_t kNumValidation = kNumCombinations / 10;

using Values = std::array<int, kNumConcepts>;

void check(CombinationId combination) {
  if (combination < CombinationId{0} || index(combination) >= kNumCombinations)
    throw std::invalid_argument("combination " + std::to_string(static_cast<int>(combination)) +
                                " is not in [0, " + std::to_string(kNumCombinations) + ")");
}

Values valuesOf(CombinationId combination) {
  check(combination);
  Values values{};
  std::size_t rest = index(combination);
  for (std::size_t i = kNumConcepts; i-- > 0; rest /= kConceptCardinality[i])
    values[i] = static_cast<int>(rest % kConceptCardinality[i]);
  return values;
}

CombinationId combinationOf(const Values& values) {
  std::size_t combination = 0;
  for (const Concept which : kConcepts) {
    const std::size_t i = index(which);
    if (values[i] < 0 || values[i] >= static_cast<int>(kConceptCardinality[i]))
      throw std::invalid_argument(std::string(name(which)) + " must be in [0, " +
                                  std::to_string(kConceptCardinality[i]) + "), not " +
                                  std::to_string(values[i]));
    combination = combination * kConceptCardinality[i] + static_cast<std::size_t>(values[i]);
  }
  return static_cast<CombinationId>(combination);
}

}  // namespace

ObjectState objectOf(CombinationId combination) {
  const Values values = valuesOf(combination);
  return {
      static_cast<ObjectType>(values[0]), {values[1], values[2]}, values[3], values[4], values[5]};
}

CombinationId combinationOf(const ObjectState& object) {
  Values values{};
  for (const Concept which : kConcepts) values[index(which)] = valueOf(object, which);
  return combinationOf(values);
}

int valueOf(const ObjectState& object, Concept which) {
  switch (which) {
    case Concept::kType:
      return static_cast<int>(object.type);
    case Concept::kPositionX:
      return object.cell.x;
    case Concept::kPositionY:
      return object.cell.y;
    case Concept::kRotation:
      return object.rotation;
    case Concept::kColor:
      return object.color;
    case Concept::kSize:
      return object.size;
  }
  throw std::invalid_argument("no concept " + std::to_string(static_cast<int>(which)));
}

ConceptSet::ConceptSet(std::uint64_t seed) : seed_(seed), split_of_(kNumCombinations) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order(kNumCombinations);
  for (std::size_t i = 0; i < kNumCombinations; ++i) order[i] = {stableHash({seed, i}), i};
  std::sort(order.begin(), order.end());
  for (std::size_t rank = 0; rank < kNumCombinations; ++rank)
    split_of_[order[rank].second] = rank < kNumTrain                    ? Split::kTrain
                                    : rank < kNumTrain + kNumValidation ? Split::kValidation
                                                                        : Split::kTest;
  for (std::size_t i = 0; i < kNumCombinations; ++i)
    combinations_[static_cast<std::size_t>(split_of_[i])].push_back(static_cast<CombinationId>(i));
}

Split ConceptSet::split(CombinationId combination) const {
  check(combination);
  return split_of_[index(combination)];
}

const std::vector<CombinationId>& ConceptSet::combinations(Split split) const {
  return combinations_.at(static_cast<std::size_t>(split));
}

std::vector<CombinationId> ConceptSet::partners(CombinationId combination, Concept which) const {
  const Split own = split(combination);
  Values values = valuesOf(combination);
  std::vector<CombinationId> partners;
  for (int value = 0; value < static_cast<int>(kConceptCardinality[index(which)]); ++value) {
    values[index(which)] = value;
    const CombinationId candidate = combinationOf(values);
    if (candidate != combination && split(candidate) == own) partners.push_back(candidate);
  }
  return partners;
}

std::uint64_t ConceptSet::appearance(CombinationId combination, int sample) const {
  check(combination);
  if (sample < 0 || sample >= kNumColorSamples)
    throw std::invalid_argument("sample " + std::to_string(sample) + " is not in [0, " +
                                std::to_string(kNumColorSamples) + ")");
  auto number = static_cast<std::uint64_t>(sample);
  if (split(combination) != Split::kTrain)
    number =
        (stableHash({seed_, index(combination), kNumColorSamples}) % kNumColorSamples + number) %
        kNumColorSamples;
  return (stableHash({seed_, index(combination), number}) >> 7) * kNumColorSamples + number;
}

}  // namespace conceptplan
