#include "planners/grid_world.hpp"

#include <numeric>

#include "conceptplan/domain/simulation/random_stream.hpp"

namespace conceptplan::testing {
namespace {

ContextFeature own(Concept which) { return {ContextKind::kOwnSymbol, which, SymbolId{0}}; }

/// From each symbol surely to the one `shift` further on, around the end.
Effect shifted(Concept which, std::size_t symbols, std::size_t shift) {
  Effect effect{{own(which)}, {}, 1};
  for (std::size_t from = 0; from < symbols; ++from) {
    std::vector<double> row(symbols, 0);
    row[(from + shift) % symbols] = 1;
    effect.rows[from] = std::move(row);
  }
  return effect;
}

/// Legal but in one symbol.
LegalityFactor everywhereBut(std::size_t symbol, Concept which, std::size_t symbols) {
  LegalityFactor factor{own(which), std::vector<double>(symbols, 0.2)};
  factor.share[symbol] = 0;
  return factor;
}

}  // namespace

GridWorld gridWorld(int columns, int rows, int rotations, double obstacle_share,
                    std::uint64_t seed) {
  const auto width = static_cast<std::size_t>(columns);
  const auto height = static_cast<std::size_t>(rows);
  const auto turns = static_cast<std::size_t>(rotations);
  const ConceptCardinality cardinality{1, width, height, turns, 1, 1};
  EffectTable effects;
  LegalityTable legality;
  const auto move = [&](Action action, Concept which, std::size_t symbols, bool forward) {
    effects[index(action)][index(which)] = shifted(which, symbols, forward ? 1 : symbols - 1);
    legality[index(action)] = {everywhereBut(forward ? symbols - 1 : 0, which, symbols)};
  };
  move(Action::kMoveRight, Concept::kPositionX, width, true);
  move(Action::kMoveLeft, Concept::kPositionX, width, false);
  move(Action::kMoveFront, Concept::kPositionY, height, true);
  move(Action::kMoveBack, Concept::kPositionY, height, false);
  const auto turn = [&](Action action, std::size_t shift) {
    effects[index(action)][index(Concept::kRotation)] = shifted(Concept::kRotation, turns, shift);
  };
  turn(Action::kRotateLeft, 1);
  turn(Action::kRotateRight, turns - 1);

  SymbolGrounding grounding;
  grounding.columns.resize(width);
  grounding.rows.resize(height);
  std::iota(grounding.columns.begin(), grounding.columns.end(), 0);
  std::iota(grounding.rows.begin(), grounding.rows.end(), 0);
  grounding.footprints = uniformFootprints(cardinality, {outlineOfDisc(0.05), 0.1});

  const auto object = [&](std::size_t x, std::size_t y, std::size_t rotation) {
    Symbols symbols{};
    symbols[index(Concept::kPositionX)] = static_cast<SymbolId>(x);
    symbols[index(Concept::kPositionY)] = static_cast<SymbolId>(y);
    symbols[index(Concept::kRotation)] = static_cast<SymbolId>(rotation);
    return certain(symbols, cardinality);
  };
  SymbolicProblem problem;
  problem.initial.workbench.columns = columns;
  problem.initial.workbench.rows = rows;
  problem.initial.objects = {object(0, 0, 0)};
  problem.goal = object(width - 1, height - 1, turns / 2);
  RandomStream draws({seed, 17});
  for (std::size_t cell = 1; cell + 1 < width * height; ++cell) {
    if (static_cast<double>(draws.below(1000)) >= 1000 * obstacle_share) continue;
    problem.initial.objects.push_back(object(cell % width, cell / width, 0));
  }
  return {{grounding, TransitionModel(cardinality, effects), ActionLegality(cardinality, legality),
           ModelEvidence{}},
          problem};
}

}  // namespace conceptplan::testing
