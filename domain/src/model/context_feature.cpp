#include "conceptplan/domain/model/context_feature.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <tuple>

namespace conceptplan {
namespace {

constexpr std::size_t kOffsetsPerAxis = 2 * kOffsetReach + 1;

struct Neighbour {
  const Symbols* symbols = nullptr;
  int dx = 0;
  int dy = 0;

  std::tuple<int, int, int> rank() const { return {std::abs(dx) + std::abs(dy), dy, dx}; }
};

std::optional<Neighbour> nearest(SymbolId type, const Surroundings& surroundings) {
  const Cell own = surroundings.grounding.cell(surroundings.target);
  std::optional<Neighbour> best;
  for (const Symbols& other : surroundings.others) {
    if (other[index(Concept::kType)] != type) continue;
    const Cell cell = surroundings.grounding.cell(other);
    const Neighbour candidate{&other, cell.x - own.x, cell.y - own.y};
    if (!best || candidate.rank() < best->rank()) best = candidate;
  }
  return best;
}

std::size_t clipped(int offset) {
  return static_cast<std::size_t>(std::clamp(offset, -kOffsetReach, kOffsetReach) + kOffsetReach);
}

}  // namespace

std::optional<std::size_t> nearestObject(SymbolId type, const Surroundings& surroundings) {
  const std::optional<Neighbour> neighbour = nearest(type, surroundings);
  if (!neighbour) return std::nullopt;
  return static_cast<std::size_t>(neighbour->symbols - surroundings.others.data());
}

std::size_t valueCount(const ContextFeature& feature, const ConceptCardinality& cardinality) {
  switch (feature.kind) {
    case ContextKind::kOwnSymbol:
      return cardinality[index(feature.which)];
    case ContextKind::kNearestSymbol:
      return cardinality[index(feature.which)] + 1;
    case ContextKind::kNearestOffset:
      break;
  }
  return kOffsetsPerAxis * kOffsetsPerAxis + 1;
}

std::size_t valueOf(const ContextFeature& feature, const ConceptCardinality& cardinality,
                    const Surroundings& surroundings) {
  if (feature.kind == ContextKind::kOwnSymbol) {
    return index(surroundings.target[index(feature.which)]);
  }
  const std::optional<Neighbour> neighbour = nearest(feature.type, surroundings);
  if (!neighbour) return valueCount(feature, cardinality) - 1;
  if (feature.kind == ContextKind::kNearestSymbol) {
    return index((*neighbour->symbols)[index(feature.which)]);
  }
  return clipped(neighbour->dy) * kOffsetsPerAxis + clipped(neighbour->dx);
}

bool isAbsent(const ContextFeature& feature, const ConceptCardinality& cardinality,
              std::size_t value) {
  return feature.kind != ContextKind::kOwnSymbol && value + 1 == valueCount(feature, cardinality);
}

std::size_t jointValueOf(std::span<const ContextFeature> features,
                         const ConceptCardinality& cardinality, const Surroundings& surroundings) {
  std::size_t joint = 0;
  for (const ContextFeature& feature : features) {
    joint = joint * valueCount(feature, cardinality) + valueOf(feature, cardinality, surroundings);
  }
  return joint;
}

std::vector<std::size_t> splitJointValue(std::span<const ContextFeature> features,
                                         const ConceptCardinality& cardinality, std::size_t joint) {
  std::vector<std::size_t> values(features.size());
  for (std::size_t i = features.size(); i-- > 0;) {
    const std::size_t count = valueCount(features[i], cardinality);
    values[i] = joint % count;
    joint /= count;
  }
  return values;
}

std::string describe(const ContextFeature& feature, const SymbolGrounding& grounding) {
  const std::string which(name(feature.which));
  if (feature.kind == ContextKind::kOwnSymbol) return "own " + which;
  const std::string object = "the nearest " + grounding.name(Concept::kType, feature.type);
  if (feature.kind == ContextKind::kNearestSymbol) return which + " of " + object;
  return "offset to " + object;
}

}  // namespace conceptplan
