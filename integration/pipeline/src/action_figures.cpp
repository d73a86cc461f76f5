#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "conceptplan/learner/effect_context.hpp"
#include "figure_parts.hpp"
#include "report_markup.hpp"
#include "svg_drawing.hpp"

namespace conceptplan::figures {
namespace {

constexpr double kLegality = 0.01;  // the default threshold of Eq. (5)

std::string spaced(std::string_view words) {
  std::string text(words);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// One object of each TYPE symbol, drawn at random.
std::vector<const ReadObject*> companions(const Material& material, std::mt19937_64& generator) {
  const auto& objects = material.objects;
  std::vector<const ReadObject*> chosen;
  const std::size_t types = material.model.symbolic().cardinality()[index(Concept::kType)];
  for (std::size_t type = 0; type < types; ++type) {
    const std::size_t start = generator() % objects.size();
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const ReadObject& object = objects[(start + i) % objects.size()];
      if (index(object.symbols[index(Concept::kType)]) != type) continue;
      chosen.push_back(&object);
      break;
    }
  }
  return chosen;
}

/// The mix of two colours, "#rrggbb"; share 0 is white.
std::string shade(double share) {
  constexpr std::array<double, 3> kDark{16, 78, 139};
  std::string color = "#";
  for (const double dark : kDark) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto level = static_cast<unsigned>(std::lround(255 + share * (dark - 255)));
    color += {kDigits[level / 16], kDigits[level % 16]};
  }
  return color;
}

/// w of least norm (with c) for which w . centre + c is the place of each symbol.
Eigen::VectorXd readout(const TokenMatrix& centers, const std::vector<int>& places) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Ones(centers.rows(), centers.cols() + 1);
  points.leftCols(centers.cols()) = centers.cast<double>();
  Eigen::VectorXd targets(points.rows());
  for (Eigen::Index i = 0; i < targets.size(); ++i)
    targets[i] = places[static_cast<std::size_t>(i)];
  const Eigen::MatrixXd gram = points * points.transpose();
  return (points.transpose() * gram.ldlt().solve(targets)).head(centers.cols());
}

}  // namespace

Effects applyActions(const Material& material, std::mt19937_64& generator) {
  const SymbolicModel& symbolic = material.model.symbolic();
  Effects effects;
  for (const ReadObject& object : material.objects) {
    std::vector<Symbols> others;
    std::vector<Tokens> other_tokens;
    for (const ReadObject* other : companions(material, generator)) {
      others.push_back(other->symbols);
      other_tokens.push_back(other->tokens);
    }
    for (const Action action : kActions) {
      const Surroundings surroundings{symbolic.grounding, object.symbols, others};
      if (symbolic.legality.probability(action, surroundings) <= kLegality) continue;
      const Tokens context = effectContext(symbolic, action, object.symbols, others, other_tokens);
      effects.steps[index(action)].push_back(
          {object.tokens, material.model.transition().apply(object.tokens, context, action)});
    }
  }
  return effects;
}

Figure tokenChanges(const Material& material, const Effects& effects) {
  constexpr double kLeft = 176, kTop = 118, kWidth = 116, kHeight = 46;
  SvgDrawing drawing(kLeft + kNumConcepts * kWidth + 28, kTop + kNumActions * kHeight + 24,
                     "Change of each token under each action",
                     "A table of seven actions and six tokens with the mean length of the change.");
  drawing.text({28, 38}, "What each action changes", {24, {}, true});
  drawing.text({28, 64},
               "Mean l2 norm of the change of each token (tokens have length 8); " + material.set,
               {16, {}, false, kQuiet});
  std::array<std::array<double, kNumConcepts>, kNumActions> change{};
  double largest = 1e-9;
  for (std::size_t a = 0; a < kNumActions; ++a)
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      for (const Effects::Step& step : effects.steps[a])
        change[a][k] += (step.after.row(row) - step.before.row(row)).norm() /
                        static_cast<double>(effects.steps[a].size());
      largest = std::max(largest, change[a][k]);
    }
  for (const Concept which : kConcepts)
    drawing.text({kLeft + kWidth * (static_cast<double>(index(which)) + 0.5), kTop - 12},
                 name(which), {14, Anchor::kMiddle, true});
  for (const Action action : kActions) {
    const double y = kTop + kHeight * static_cast<double>(index(action));
    drawing.text({kLeft - 14, y + kHeight / 2 + 6}, spaced(name(action)), {16, Anchor::kEnd});
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      const double value = change[index(action)][k], share = value / largest;
      const double x = kLeft + kWidth * static_cast<double>(k);
      drawing.rectangle({x, y}, kWidth - 3, kHeight - 3, shade(share), "#d5dae0");
      const bool none = effects.steps[index(action)].empty();
      drawing.text({x + kWidth / 2 - 1.5, y + kHeight / 2 + 5},
                   none ? "never legal" : report::decimal(value, 2),
                   {16, Anchor::kMiddle, false, share > 0.5 ? "#ffffff" : "#22262b"});
    }
  }
  return {"token-changes", drawing.svg()};
}

Figure displacements(const Material& material, const Effects& effects) {
  constexpr double kPanel = 210, kStepX = 240, kStepY = 272, kLeft = 40, kTop = 128;
  constexpr double kReach = 2;  // cells from the middle of a panel to its edge
  constexpr std::array kColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                               "#8a6d00", "#56789a", "#c2261c"};
  SvgDrawing drawing(kLeft + 4 * kStepX + 2, kTop + 2 * kStepY - 4, "Displacement by each action",
                     "Seven panels, one an action: changes of column and row of single objects.");
  drawing.text({kLeft, 38}, "Where each action moves an object", {24, {}, true});
  drawing.text({kLeft, 64},
               "Cells moved, by a linear map of the tokens that the causal transition gives; " +
                   material.set,
               {16, {}, false, kQuiet});
  const SymbolicModel& symbolic = material.model.symbolic();
  const Symbolizer& symbolizer = material.model.symbols().symbolizer;
  const Eigen::VectorXd to_column =
      readout(symbolizer.clusters(Concept::kPositionX).centers, symbolic.grounding.columns);
  const Eigen::VectorXd to_row =
      readout(symbolizer.clusters(Concept::kPositionY).centers, symbolic.grounding.rows);
  for (const Action action : kActions) {
    const auto a = static_cast<int>(index(action));
    const Point corner{kLeft + kStepX * (a % 4), kTop + kStepY * (a / 4)};
    const double scale = kPanel / (2 * kReach);
    const auto at = [&](double columns, double rows) {
      return Point{corner.x + kPanel / 2 + scale * std::clamp(columns, -kReach, kReach),
                   corner.y + kPanel / 2 - scale * std::clamp(rows, -kReach, kReach)};
    };
    drawing.text({corner.x, corner.y - 12}, spaced(name(action)), {17, {}, true});
    drawing.rectangle(corner, kPanel, kPanel, "#f7f8fa", "#d5dae0");
    for (int cell = -1; cell <= 1; ++cell) {
      const std::string_view color = cell == 0 ? "#9aa3ad" : "#dfe3e8";
      drawing.line(at(cell, -kReach), at(cell, kReach), color);
      drawing.line(at(-kReach, cell), at(kReach, cell), color);
      const std::string label = cell > 0 ? "+1" : cell < 0 ? "\u22121" : "0";
      drawing.text({at(cell, 0).x, corner.y + kPanel + 18}, label,
                   {13, Anchor::kMiddle, false, kQuiet});
      drawing.text({corner.x - 6, at(0, cell).y + 5}, label, {13, Anchor::kEnd, false, kQuiet});
    }
    std::vector<Point> points;
    for (const Effects::Step& step : effects.steps[index(action)]) {
      const Tokens change = step.after - step.before;
      const auto along = [&](Concept which, const Eigen::VectorXd& direction) {
        return change.row(static_cast<Eigen::Index>(index(which))).cast<double>().dot(direction);
      };
      points.push_back(
          at(along(Concept::kPositionX, to_column), along(Concept::kPositionY, to_row)));
    }
    drawing.dots(points, kColors[index(action)], 4, 0.4);
    drawing.text({corner.x + kPanel, corner.y - 12}, std::to_string(points.size()) + " objects",
                 {13, Anchor::kEnd, false, kQuiet});
  }
  const Point note{kLeft + 3 * kStepX, kTop + kStepY + 22};
  const std::array<std::string_view, 6> words{
      "Across: columns, rightwards.",     "Up: rows, from the camera.",
      "A dot is one object to which the", "action is legal. Turns and the",
      "change of colour leave it where",  "it is: dots in the middle."};
  for (std::size_t i = 0; i < words.size(); ++i)
    drawing.text({note.x, note.y + 23 * static_cast<double>(i)}, words[i], {14, {}, false, kQuiet});
  return {"displacements", drawing.svg()};
}

}  // namespace conceptplan::figures
