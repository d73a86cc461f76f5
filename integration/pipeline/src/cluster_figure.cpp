#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "conceptplan/learner/disentanglement/principal_axes.hpp"
#include "figure_parts.hpp"
#include "report_markup.hpp"
#include "svg_drawing.hpp"

namespace conceptplan::figures {
namespace {

constexpr double kPanel = 310, kStepX = 346, kStepY = 430, kLeft = 28, kTop = 140;
constexpr double kOpacity = 0.6;
constexpr std::array kPalette{"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                              "#8c564b", "#d55e00", "#7a5195", "#8c8c8c"};

/// One concept's token of each object. [objects, 64]
Eigen::MatrixXd tokensOf(const std::vector<ReadObject>& objects, Eigen::Index token) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(objects.size()), Tokens::ColsAtCompileTime);
  for (std::size_t i = 0; i < objects.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = objects[i].tokens.row(token).cast<double>();
  return rows;
}

/// How near the two nearest of some places are to each other. [places, 2]
double leastDistance(const Eigen::MatrixX2d& places) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index a = 1; a < places.rows(); ++a)
    for (Eigen::Index b = 0; b < a; ++b)
      least = std::min(least, (places.row(a) - places.row(b)).norm());
  return least;
}

/// Two orthonormal axes along which the two centres that look nearest to each other look as far
/// apart as random steps find. Eight clusters that are all equally far apart have no two principal
/// components that show more than some of them. [64, 2]
Eigen::MatrixX2d separatingAxes(const Eigen::MatrixXd& centers) {
  constexpr int kSteps = 4000;
  const Eigen::MatrixXd span =
      principalAxes(centers, std::max<Eigen::Index>(2, centers.rows() - 1));
  const Eigen::MatrixXd places = centers * span;
  std::mt19937_64 generator(1);
  Eigen::MatrixX2d best = Eigen::MatrixX2d::Identity(span.cols(), 2);
  double most = leastDistance(places * best);
  for (int step = 0; step < kSteps; ++step) {
    const double length = 1.0 - static_cast<double>(step) / kSteps;
    Eigen::MatrixX2d axes = best;
    for (double& number : axes.reshaped())
      number += length * (static_cast<double>(generator() >> 11) * 0x1p-52 - 1);
    axes.col(0).normalize();
    axes.col(1) -= axes.col(0) * axes.col(0).dot(axes.col(1));
    axes.col(1).normalize();
    const double distance = leastDistance(places * axes);
    if (distance > most) most = distance, best = axes;
  }
  return span * best;
}

std::string_view colorOf(Concept which, int value) {
  constexpr std::array<std::string_view, 6> kTrue{"#d62728", "#d9b300", "#2ca02c",
                                                  "#17becf", "#1f3fd6", "#d633c8"};
  return which == Concept::kColor ? kTrue[static_cast<std::size_t>(value)]
                                  : kPalette[static_cast<std::size_t>(value) % kPalette.size()];
}

void panel(SvgDrawing& drawing, const Material& material, Concept which, Point corner) {
  const std::size_t k = index(which);
  const Eigen::MatrixXd tokens = tokensOf(material.objects, static_cast<Eigen::Index>(k));
  const Eigen::MatrixX2d points =
      tokens *
      separatingAxes(material.model.symbols().symbolizer.clusters(which).centers.cast<double>());
  const auto variance = [](const Eigen::MatrixXd& rows) {
    return (rows.rowwise() - rows.colwise().mean()).squaredNorm();
  };
  drawing.text({corner.x, corner.y - 12}, name(which), {18, {}, true});
  drawing.text({corner.x + kPanel, corner.y - 12},
               report::decimal(100 * variance(points) / variance(tokens), 0) + " % of the variance",
               {14, Anchor::kEnd, false, kQuiet});
  drawing.rectangle(corner, kPanel, kPanel, "#f7f8fa", "#d5dae0");

  const Eigen::RowVector2d low = points.colwise().minCoeff();
  const Eigen::RowVector2d extent = points.colwise().maxCoeff() - low;
  const double scale = (kPanel - 28) / std::max(1e-9, extent.maxCoeff());
  const std::vector<int>& values = material.model.symbols().values[k];
  std::vector<std::vector<Point>> of_symbol(values.size());
  std::vector<Point> misread;
  for (std::size_t i = 0; i < material.objects.size(); ++i) {
    const Eigen::RowVector2d place =
        (points.row(static_cast<Eigen::Index>(i)) - low - extent / 2) * scale;
    const Point at{corner.x + kPanel / 2 + place.x(), corner.y + kPanel / 2 - place.y()};
    const ReadObject& object = material.objects[i];
    const std::size_t symbol = index(object.symbols[k]);
    of_symbol[symbol].push_back(at);
    if (values[symbol] != valueOf(object.sample.object, which)) misread.push_back(at);
  }
  for (std::size_t symbol = 0; symbol < values.size(); ++symbol)
    drawing.dots(of_symbol[symbol], colorOf(which, values[symbol]), 5.5, kOpacity);
  drawing.crosses(misread, "#111111", 6);

  std::vector<std::size_t> order(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return std::pair(values[a], a) < std::pair(values[b], b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    constexpr std::size_t kAcross = 3;
    const double x = corner.x + 6 + static_cast<double>(i % kAcross) * (kPanel / kAcross);
    const double y = corner.y + kPanel + 22 + 20 * static_cast<double>(i / kAcross);
    const Point mark{x, y - 5};
    drawing.dots({&mark, 1}, colorOf(which, values[order[i]]), 10, kOpacity);
    drawing.text({x + 11, y},
                 material.model.symbols().grounding.name(
                     which, SymbolId{static_cast<std::int32_t>(order[i])}),
                 {13});
  }
}

}  // namespace

Figure clusters(const Material& material) {
  SvgDrawing drawing(kLeft + 3 * kStepX - 8, kTop + 2 * kStepY - 52,
                     "Clusters of the tokens of each concept",
                     "Six panels, one a concept: tokens of single objects in two dimensions, "
                     "coloured by symbol.");
  drawing.text({kLeft, 38}, "The symbols of each concept", {24, {}, true});
  drawing.text({kLeft, 64},
               "Tokens in the plane in which the nearest clusters look farthest apart; crosses are "
               "misread.",
               {16, {}, false, kQuiet});
  drawing.text({kLeft, 88}, "From " + material.set + ".", {16, {}, false, kQuiet});
  for (const Concept which : kConcepts) {
    const auto k = static_cast<int>(index(which));
    panel(drawing, material, which, {kLeft + kStepX * (k % 3), kTop + kStepY * (k / 3)});
  }
  return {"clusters", drawing.svg()};
}

}  // namespace conceptplan::figures
