#include "integration/report/sample_report.hpp"

#include <cmath>

namespace conceptplan {
namespace {

SymbolBelief belief(const std::array<int, kNumConcepts>& values, double confidence) {
  SymbolBelief all;
  for (const Concept which : kConcepts) {
    const std::size_t count = kConceptCardinality[index(which)];
    all[index(which)].assign(count, (1 - confidence) / static_cast<double>(count - 1));
    all[index(which)][static_cast<std::size_t>(values[index(which)])] = confidence;
  }
  return all;
}

Symbols symbols(const std::array<int, kNumConcepts>& values) {
  Symbols all;
  for (const Concept which : kConcepts) {
    all[index(which)] = static_cast<SymbolId>(values[index(which)]);
  }
  return all;
}

// Discs of the instances 1, 2, 3 on a shaded table.
RgbdImage picture(int target_x, int target_y, bool blue) {
  RgbdImage image{kFrameWidth, kFrameHeight, {}, {}, {}};
  const std::array<std::array<int, 3>, 3> discs{
      {{target_x, target_y, 18}, {150, 120, 24}, {250, 70, 20}}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::array<int, 3> color{150 + y / 4, 130 + y / 5, 110 + x / 16};
      int id = 0;
      for (int i = 0; i < 3; ++i) {
        if (std::hypot(x - discs[i][0], y - discs[i][1]) >= discs[i][2]) continue;
        id = i + 1;
        color = {i == 0 && !blue ? 200 : 60, i == 1 ? 160 : 70, i == 0 && !blue ? 60 : 190};
      }
      for (const int channel : color) image.rgb.push_back(static_cast<std::uint8_t>(channel));
      image.mask.push_back(static_cast<std::uint8_t>(id));
    }
  }
  return image;
}

}  // namespace

Report sampleReport() {
  Report report;
  report.title = "level4-0007";
  report.verdict = "The simulator confirms it.";
  report.grounding = standardGrounding();
  report.problem.initial.objects = {belief({1, 0, 1, 0, 0, 2}, 0.97),
                                    belief({6, 1, 2, 2, 2, 3}, 0.91),
                                    belief({7, 2, 3, 1, 4, 1}, 0.995)};
  report.problem.initial.target = 0;
  report.problem.goal = belief({1, 0, 3, 1, 4, 2}, 0.94);
  report.initial = picture(90, 180, false);
  report.goal = picture(100, 70, true);
  report.doubts = {"In the goal picture, the TYPE of object 2 is like none that was learned."};
  report.legality_threshold = 0.01;

  PlanResult& result = report.result;
  result.status = PlanStatus::kSolved;
  Plan best;
  best.actions = {Action::kMoveFront,   Action::kMoveFront, Action::kMoveRight,
                  Action::kChangeColor, Action::kMoveLeft,  Action::kRotateLeft};
  best.predicted = {symbols({1, 0, 2, 0, 0, 2}), symbols({1, 0, 3, 0, 0, 2}),
                    symbols({1, 1, 3, 0, 0, 2}), symbols({1, 1, 3, 0, 4, 2}),
                    symbols({1, 0, 3, 0, 4, 2}), symbols({1, 0, 3, 1, 4, 2})};
  best.probability = 0.8731;
  best.cost = 0.1357;
  Plan second = best;
  std::swap(second.actions[4], second.actions[5]);
  second.probability = 0.8512;
  second.cost = 0.1611;
  result.plans = {best, second};
  for (const Symbols& after : best.predicted) {
    const Cell cell = report.grounding.cell(after);
    const bool blue = after[index(Concept::kColor)] == SymbolId{4};
    report.frames.push_back({picture(92 + 70 * cell.x, 230 - 52 * cell.y, blue),
                             picture(90 + 70 * cell.x, 230 - 52 * cell.y, blue)});
  }
  result.statistics = {118, 402, 15};
  for (int i = 0; i < 3; ++i) {
    result.rejections.push_back(
        {symbols({1, 0, 2, i, 0, 2}), Action::kMoveRight, Invalidity::kCollision, 1, -0.04});
    result.rejections.push_back({symbols({1, 0, i, 0, 0, 2}), Action::kChangeColor,
                                 Invalidity::kNone, std::nullopt, 0.001 * i});
  }
  result.rejections.push_back({symbols({1, 0, 1, 0, 0, 2}), Action::kMoveLeft,
                               Invalidity::kWorkbenchEdge, std::nullopt, -0.02});
  report.times_ms = {{"Perceive", 41.2}, {"Compile", 1.31}, {"Search", 3.42}, {"Render", 96.0}};
  report.facts = {{"Planner", "belief"}, {"Seed", "0"}, {"Model", "default"}};
  report.versions = {{"ConceptPlan", "0.1.0"}, {"Torch", "1.13.1"}};
  return report;
}

}  // namespace conceptplan
