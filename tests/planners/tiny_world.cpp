#include "planners/tiny_world.hpp"

namespace conceptplan::testing {
namespace {

ContextFeature own(Concept which) { return {ContextKind::kOwnSymbol, which, SymbolId{0}}; }

Effect& effectOn(EffectTable& effects, Action action, Concept which) {
  return effects[index(action)][index(which)];
}

}  // namespace

SymbolicModel tinyModel() {
  EffectTable effects;
  effectOn(effects, Action::kMoveRight, Concept::kPositionX) = {
      {own(Concept::kPositionX)}, {{0, {0.2, 0.8, 0}}, {1, {0, 0.2, 0.8}}}, 1};
  effectOn(effects, Action::kMoveLeft, Concept::kPositionX) = {
      {own(Concept::kPositionX)}, {{1, {1, 0, 0}}, {2, {0, 1, 0}}}, 1};
  effectOn(effects, Action::kRotateLeft, Concept::kRotation) = {
      {own(Concept::kRotation)}, {{0, {0.1, 0.9}}, {1, {0.9, 0.1}}}, 1};
  effectOn(effects, Action::kChangeColor, Concept::kColor) = {
      {{ContextKind::kNearestSymbol, Concept::kColor, SymbolId{1}}}, {{0, {1, 0}}, {1, {0, 1}}}, 1};
  LegalityTable legality;
  legality[index(Action::kMoveRight)] = {{own(Concept::kPositionX), {0.3, 0.3, 0.001}}};
  legality[index(Action::kMoveLeft)] = {{own(Concept::kPositionX), {0, 0.3, 0.3}}};

  SymbolGrounding grounding;
  grounding.columns = {0, 1, 2};
  grounding.rows = {0};
  grounding.footprints = uniformFootprints(kTinyCardinality, {outlineOfDisc(0.05), 0.1});
  return {grounding, TransitionModel(kTinyCardinality, effects),
          ActionLegality(kTinyCardinality, legality), ModelEvidence{}};
}

Symbols tinySymbols(int type, int column, int rotation, int color) {
  return {SymbolId{type},     SymbolId{column}, SymbolId{0},
          SymbolId{rotation}, SymbolId{color},  SymbolId{0}};
}

SymbolicProblem tinyProblem(const Symbols& start, const Symbols& goal) {
  SymbolicProblem problem;
  problem.initial.workbench.rows = 1;
  problem.initial.objects = {certain(start, kTinyCardinality)};
  problem.goal = certain(goal, kTinyCardinality);
  return problem;
}

}  // namespace conceptplan::testing
