#include "half_turn.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "conceptplan/learner/turn_residual.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kRotation = index(Concept::kRotation);
constexpr int kQuarterTurns = 4;
// Chosen on validation tasks: how well half a turn more must fit, and by how much better.
constexpr double kMostResidual = 0.25;
constexpr double kLeastGain = 0.1;

/// The ROTATION symbol that most probably follows `rotate_left`, of each; nothing where that is not
/// a quarter turn: four of them lead back, and two do not.
std::optional<std::vector<std::size_t>> turnedLeft(const SymbolicModel& model,
                                                   const SymbolBelief& belief) {
  Symbols symbols = mostProbable(belief);
  std::vector<std::size_t> next;
  for (std::size_t symbol = 0; symbol < model.cardinality()[kRotation]; ++symbol) {
    symbols[kRotation] = SymbolId{static_cast<std::int32_t>(symbol)};
    const std::vector<double> after = model.transitions.distribution(
        Action::kRotateLeft, Concept::kRotation, {model.grounding, symbols, {}});
    next.push_back(static_cast<std::size_t>(std::ranges::max_element(after) - after.begin()));
  }
  for (std::size_t symbol = 0; symbol < next.size(); ++symbol) {
    const std::size_t opposite = next[next[symbol]];
    if (opposite == symbol || next[next[opposite]] != symbol) return std::nullopt;
  }
  return next;
}

/// How often an object must be turned left until it has that symbol; nothing if it never has.
std::optional<int> quarterTurns(const std::vector<std::size_t>& next, std::size_t from,
                                std::size_t to) {
  for (int turns = 0; turns < kQuarterTurns; ++turns, from = next[from])
    if (from == to) return turns;
  return std::nullopt;
}

ObjectView viewOf(const SymbolicModel& model, const BelievedObject& object) {
  return {object.image, object.instance,
          Workbench{}.p_WCell(model.grounding.cell(mostProbable(object.belief)))};
}

}  // namespace

bool isTurnedRound(const SymbolicModel& model, const BelievedObject& before,
                   const BelievedObject& after) {
  const auto next = turnedLeft(model, before.belief);
  if (!next) return false;
  const auto turns = quarterTurns(*next, index(mostProbable(before.belief)[kRotation]),
                                  index(mostProbable(after.belief)[kRotation]));
  if (!turns) return false;
  const Camera camera = standardCamera();
  const ObjectView first = viewOf(model, before), second = viewOf(model, after);
  const double residual = turnResidual(first, second, *turns + kQuarterTurns / 2, camera);
  return residual < kMostResidual &&
         turnResidual(first, second, *turns, camera) - residual > kLeastGain;
}

SymbolBelief turnedRound(const SymbolicModel& model, SymbolBelief belief) {
  const auto next = turnedLeft(model, belief);
  if (!next) return belief;
  std::vector<double> rotations(next->size(), 0);
  for (std::size_t symbol = 0; symbol < next->size(); ++symbol)
    rotations[(*next)[(*next)[symbol]]] += belief[kRotation][symbol];
  belief[kRotation] = std::move(rotations);
  return belief;
}

}  // namespace conceptplan
