#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "conceptplan/pipeline/model.hpp"
#include "rendering/object_models.hpp"

namespace conceptplan {
namespace {

/// How far the object reaches about the middle of its cell, and how high.
Footprint trueFootprint(ObjectType type, int size, int rotation) {
  Footprint footprint;
  const Eigen::Rotation2Df turn(static_cast<float>(rotation) * 1.5707963F);
  for (const Eigen::Vector3f& position : rendering::objectModel(type).positions) {
    const Eigen::Vector3f p = static_cast<float>(sizeScale(size)) * position;
    const Eigen::Vector2d seen = (turn * p.head<2>()).cast<double>();
    for (std::size_t k = 0; k < Outline::kDirections; ++k) {
      double& support_m = footprint.outline.support_m[k];
      support_m = std::max(support_m, outlineDirection(k).dot(seen));
    }
    footprint.height_m = std::max<double>(footprint.height_m, p.z());
  }
  return footprint;
}

TEST(ShippedFootprints, SurroundTheObjectsThatTheyWereMeasuredFrom) {
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  const LearnedSymbols& symbols = model.symbols();
  const FootprintTable& table = symbols.grounding.footprints;
  double sum_m = 0, most_missed_m = 0, most_added_m = 0, most_height_m = 0;
  int count = 0;
  for (std::size_t type = 0; type < table.size(); ++type) {
    for (std::size_t size = 0; size < table[type].size(); ++size) {
      for (std::size_t rotation = 0; rotation < table[type][size].size(); ++rotation) {
        const Footprint& learned = table[type][size][rotation];
        const Footprint truth =
            trueFootprint(static_cast<ObjectType>(symbols.values[index(Concept::kType)][type]),
                          symbols.values[index(Concept::kSize)][size],
                          symbols.values[index(Concept::kRotation)][rotation]);
        for (std::size_t k = 0; k < Outline::kDirections; ++k) {
          const double more_m = learned.outline.support_m[k] - truth.outline.support_m[k];
          sum_m += more_m;
          ++count;
          most_missed_m = std::max(most_missed_m, -more_m);
          most_added_m = std::max(most_added_m, more_m);
        }
        most_height_m = std::max(most_height_m, std::abs(learned.height_m - truth.height_m));
      }
    }
  }
  EXPECT_LT(most_missed_m, 0.01);
  EXPECT_LT(most_added_m, 0.05);  // behind what points to the camera
  EXPECT_LT(std::abs(sum_m / count), 0.005);
  EXPECT_LT(most_height_m, 0.01);
}

}  // namespace
}  // namespace conceptplan
