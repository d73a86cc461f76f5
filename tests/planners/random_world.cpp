#include "planners/random_world.hpp"

#include <numeric>
#include <random>

#include "conceptplan/domain/simulation/random_stream.hpp"

namespace conceptplan::testing {
namespace {

constexpr ConceptCardinality kCardinality{1, 3, 2, 2, 1, 1};

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : stream_({seed, 41}) {}

  std::size_t below(std::size_t count) { return stream_.below(count); }
  double share() { return static_cast<double>(stream_.below(1000)) / 1000; }

  std::vector<double> distribution(std::size_t symbols) {
    std::vector<double> row(symbols);
    for (double& probability : row) probability = 0.001 + share();
    const double sum = std::accumulate(row.begin(), row.end(), 0.0);
    for (double& probability : row) probability /= sum;
    return row;
  }

 private:
  RandomStream stream_;
};

/// From each symbol mostly to one other, sometimes to several.
Effect drawnEffect(Concept which, Draws& draws) {
  const std::size_t symbols = kCardinality[index(which)];
  Effect effect;
  effect.context = {{ContextKind::kOwnSymbol, which, SymbolId{0}}};
  for (std::size_t from = 0; from < symbols; ++from) {
    if (draws.below(3) == 0) {
      effect.rows[from] = draws.distribution(symbols);
      continue;
    }
    const double sure = 0.5 + draws.share() / 2;
    std::vector<double> row(symbols, (1 - sure) / static_cast<double>(symbols - 1));
    row[(from + 1 + draws.below(symbols - 1)) % symbols] = sure;
    effect.rows[from] = row;
  }
  return effect;
}

SymbolicModel drawnModel(Draws& draws) {
  EffectTable effects;
  LegalityTable legality;
  const std::array<std::pair<Action, Concept>, 5> moves{
      {{Action::kMoveLeft, Concept::kPositionX},
       {Action::kMoveRight, Concept::kPositionX},
       {Action::kMoveFront, Concept::kPositionY},
       {Action::kMoveBack, Concept::kPositionY},
       {Action::kRotateLeft, Concept::kRotation}}};
  for (const auto& [action, which] : moves) {
    effects[index(action)][index(which)] = drawnEffect(which, draws);
    LegalityFactor factor{{ContextKind::kOwnSymbol, Concept::kPositionX, SymbolId{0}}, {}};
    for (int i = 0; i < 3; ++i) factor.share.push_back(draws.below(4) == 0 ? 0.005 : 0.2);
    legality[index(action)] = {factor};
  }
  // One action moves two concepts at once, so that its cost has to be shared out.
  effects[index(Action::kMoveBack)][index(Concept::kRotation)] =
      drawnEffect(Concept::kRotation, draws);
  for (const Action action : {Action::kRotateRight, Action::kChangeColor}) {
    legality[index(action)] = {{{ContextKind::kOwnSymbol, Concept::kType, SymbolId{0}}, {0.0}}};
  }
  SymbolGrounding grounding;
  grounding.columns = {0, 1, 2};
  grounding.rows = {0, 1};
  grounding.footprints = uniformFootprints(kCardinality, {outlineOfDisc(0.05), 0.1});
  return {grounding, TransitionModel(kCardinality, effects), ActionLegality(kCardinality, legality),
          ModelEvidence{}};
}

Symbols drawnSymbols(Draws& draws) {
  Symbols symbols{};
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    symbols[k] = static_cast<SymbolId>(draws.below(kCardinality[k]));
  }
  return symbols;
}

SymbolBelief drawnBelief(Draws& draws) {
  SymbolBelief belief;
  for (std::size_t k = 0; k < kNumConcepts; ++k) belief[k] = draws.distribution(kCardinality[k]);
  return belief;
}

}  // namespace

SymbolicModel randomModel(std::uint64_t seed) {
  Draws draws(seed);
  return drawnModel(draws);
}

SymbolGraph randomWorld(std::uint64_t seed, bool uncertain) {
  Draws draws(seed);
  const SymbolicModel model = drawnModel(draws);
  SymbolicProblem problem;
  problem.initial.workbench.columns = 3;
  problem.initial.workbench.rows = 2;
  const auto belief = [&] {
    return uncertain ? drawnBelief(draws) : certain(drawnSymbols(draws), kCardinality);
  };
  problem.initial.objects = {belief()};
  problem.goal = belief();
  const Cell start = model.grounding.cell(mostProbable(problem.initial.objects.front()));
  for (std::size_t obstacles = draws.below(3); obstacles > 0; --obstacles) {
    const Symbols obstacle = drawnSymbols(draws);
    if (model.grounding.cell(obstacle) == start) continue;
    problem.initial.objects.push_back(certain(obstacle, kCardinality));
  }
  return compile(model, problem, GridValidity());
}

}  // namespace conceptplan::testing
