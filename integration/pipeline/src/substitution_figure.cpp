#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "conceptplan/domain/camera.hpp"
#include "conceptplan/domain/workbench.hpp"
#include "figure_parts.hpp"
#include "svg_drawing.hpp"

namespace conceptplan::figures {
namespace {

constexpr int kEdge = ObjectCrop::kEdge;
constexpr double kTile = 98;     // edge of an object's picture
constexpr double kCell = 9;      // edge of a cell on the map beside it
constexpr double kColumn = 140;  // from tile to tile
constexpr double kRow = 114;
constexpr double kLeft = 28;
constexpr double kTop = 132;
constexpr std::size_t kPairs = 6;
constexpr float kPaper = 0.965F;  // brightness behind the objects

/// Colours of an object over paper, and where it is, as the encoder is told.
struct Shown {
  std::vector<std::uint8_t> rgb;  // [64, 64, 3]
  std::array<float, 3> location{};
};

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

Shown shown(const ObjectCrop& crop) {
  Shown result{crop.rgb, encoderInput(crop).location};
  for (std::size_t pixel = 0; pixel < crop.mask.size(); ++pixel)
    if (crop.mask[pixel] == 0)
      std::fill_n(result.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel), 3, byte(kPaper));
  return result;
}

Shown shown(const DrawnObject& object) {
  constexpr std::size_t kPixels = kEdge * kEdge;
  Shown result{std::vector<std::uint8_t>(3 * kPixels), object.location};
  for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
    for (std::size_t channel = 0; channel < 3; ++channel)
      result.rgb[3 * pixel + channel] =
          byte(std::lerp(kPaper, object.rgb[channel * kPixels + pixel], object.alpha[pixel]));
  return result;
}

/// The place in W at which an object is seen, at the median depth of what is seen of it.
Eigen::Vector3d placeOf(const std::array<float, 3>& location) {
  constexpr float kMedian = 128;  // level of the depth plane
  return standardCamera().unproject(pixelOf(location), depthOf(location, kMedian));
}

/// The object, and beside it a map of the workbench with its place.
void tile(SvgDrawing& drawing, Point corner, const Shown& object) {
  drawing.image(corner, kTile, kEdge, object.rgb);
  const Workbench workbench;
  const Point map{corner.x + kTile + 4, corner.y + kTile - workbench.rows * kCell};
  for (int row = 0; row < workbench.rows; ++row)
    for (int column = 0; column < workbench.columns; ++column)
      drawing.rectangle({map.x + kCell * column, map.y + kCell * row}, kCell, kCell, "#fff",
                        "#b9c0c8");
  const Eigen::Vector3d place = placeOf(object.location) / workbench.cell_m;
  const Point dot{map.x + kCell * (place.x() + 0.5 * workbench.columns),
                  map.y + kCell * (0.5 * workbench.rows - place.y())};
  drawing.dots({&dot, 1}, "#c2261c", 7);
}

bool differInAll(const ObjectState& a, const ObjectState& b) {
  return std::all_of(kConcepts.begin(), kConcepts.end(),
                     [&](Concept which) { return valueOf(a, which) != valueOf(b, which); });
}

using Pair = std::pair<const ReadObject*, const ReadObject*>;

/// Pairs that differ in all six concepts; the first objects of types not shown yet.
std::vector<Pair> pairsOf(const std::vector<ReadObject>& objects, std::mt19937_64& generator) {
  std::vector<Pair> pairs;
  std::vector<ObjectType> types;
  for (const ReadObject& first : objects) {
    if (pairs.size() == kPairs) break;
    if (std::find(types.begin(), types.end(), first.sample.object.type) != types.end()) continue;
    const std::size_t start = generator() % objects.size();
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const ReadObject& second = objects[(start + i) % objects.size()];
      if (!differInAll(first.sample.object, second.sample.object)) continue;
      pairs.emplace_back(&first, &second);
      types.push_back(first.sample.object.type);
      break;
    }
  }
  if (pairs.empty())
    throw std::invalid_argument("figures: no two of " + std::to_string(objects.size()) +
                                " objects differ in all six concepts");
  return pairs;
}

}  // namespace

Figure substitutionGrid(const Material& material, std::mt19937_64& generator) {
  const std::vector<Pair> pairs = pairsOf(material.objects, generator);
  const double width = kLeft + 10 * kColumn + 28;
  SvgDrawing drawing(width, kTop + kRow * static_cast<double>(pairs.size()) + 14,
                     "Substitution of single tokens",
                     "Rows of objects: picture, redrawn from its tokens, with each token replaced "
                     "by that of another object, and that other object.");
  drawing.text({kLeft, 38}, "One token replaced by that of another object", {24, {}, true});
  drawing.text({kLeft, 64},
               "Drawn from six tokens each; the map shows where. Objects of the " +
                   material.set.substr(material.set.find("of the ") + 7) + ".",
               {17, {}, false, kQuiet});
  const auto heading = [&](int column, const std::string& text, bool bold) {
    drawing.text({kLeft + kColumn * column, kTop - 14}, text, {17, {}, bold});
  };
  heading(0, "object", false);
  heading(1, "redrawn", false);
  for (const Concept which : kConcepts)
    heading(2 + static_cast<int>(index(which)), std::string(name(which)), true);
  heading(8, "redrawn", false);
  heading(9, "other", false);
  drawing.text({kLeft + 2 * kColumn, kTop - 38},
               "with this token of the other object:", {17, {}, false, kQuiet});
  for (std::size_t row = 0; row < pairs.size(); ++row) {
    const auto& [first, second] = pairs[row];
    std::vector<Tokens> tokens(8, first->tokens);
    for (Eigen::Index k = 0; k < Tokens::RowsAtCompileTime; ++k)
      tokens[static_cast<std::size_t>(k) + 1].row(k) = second->tokens.row(k);
    tokens.back() = second->tokens;
    const std::vector<DrawnObject> drawn = material.model.learner().draw(tokens);
    const double y = kTop + kRow * static_cast<double>(row);
    tile(drawing, {kLeft, y}, shown(first->sample.crop));
    for (std::size_t i = 0; i < drawn.size(); ++i)
      tile(drawing, {kLeft + kColumn * static_cast<double>(i + 1), y}, shown(drawn[i]));
    tile(drawing, {kLeft + 9 * kColumn, y}, shown(second->sample.crop));
  }
  return {"substitution-grid", drawing.svg()};
}

}  // namespace conceptplan::figures
