#include "conceptplan/domain/model/symbol_grounding.hpp"

#include <algorithm>
#include <cmath>

namespace conceptplan {
namespace {

void checkSize(const std::string& what, std::size_t expected, std::size_t found,
               std::vector<std::string>& faults) {
  if (found == expected) return;
  faults.push_back(what + ": expected " + std::to_string(expected) + " entries, found " +
                   std::to_string(found));
}

void checkAxis(const char* what, const std::vector<int>& cells, std::size_t symbols,
               std::vector<std::string>& faults) {
  checkSize(what, symbols, cells.size(), faults);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] < 0) {
      faults.push_back(std::string(what) + "[" + std::to_string(i) +
                       "]: expected a cell index >= 0, found " + std::to_string(cells[i]));
    }
  }
}

bool isLength(double value_m) { return std::isfinite(value_m) && value_m > 0; }

constexpr double kTight_m = 1e-6;  // of numbers that were stored with seven digits

void checkFootprint(const std::string& what, const Footprint& footprint,
                    std::vector<std::string>& faults) {
  const auto& support_m = footprint.outline.support_m;
  if (!isLength(footprint.height_m)) {
    faults.push_back(what + ": expected a height > 0 m, found " +
                     std::to_string(footprint.height_m));
  }
  if (!std::all_of(support_m.begin(), support_m.end(), isLength)) {
    faults.push_back(what + ": expected supports > 0 m");
    return;
  }
  const Outline tight = tightened(footprint.outline);
  for (std::size_t k = 0; k < Outline::kDirections; ++k) {
    if (support_m[k] > tight.support_m[k] + kTight_m) {
      faults.push_back(what + ": expected an outline that reaches its support of " +
                       std::to_string(support_m[k]) + " m in direction " + std::to_string(k) +
                       ", the others leave it " + std::to_string(tight.support_m[k]) + " m");
      return;
    }
  }
}

}  // namespace

FootprintTable uniformFootprints(const ConceptCardinality& cardinality,
                                 const Footprint& footprint) {
  const std::vector<Footprint> of_size(cardinality[index(Concept::kRotation)], footprint);
  const std::vector<std::vector<Footprint>> of_type(cardinality[index(Concept::kSize)], of_size);
  return FootprintTable(cardinality[index(Concept::kType)], of_type);
}

Cell SymbolGrounding::cell(const Symbols& symbols) const {
  return {columns[index(symbols[index(Concept::kPositionX)])],
          rows[index(symbols[index(Concept::kPositionY)])]};
}

const Footprint& SymbolGrounding::footprint(const Symbols& symbols) const {
  return footprints[index(symbols[index(Concept::kType)])][index(symbols[index(Concept::kSize)])]
                   [index(symbols[index(Concept::kRotation)])];
}

std::string SymbolGrounding::name(Concept which, SymbolId symbol) const {
  const std::vector<std::string>& known = names[index(which)];
  if (index(symbol) < known.size() && !known[index(symbol)].empty()) return known[index(symbol)];
  return std::string(conceptplan::name(which)) + " " + std::to_string(index(symbol));
}

std::vector<std::string> SymbolGrounding::faults(const ConceptCardinality& cardinality) const {
  std::vector<std::string> found;
  checkAxis("columns", columns, cardinality[index(Concept::kPositionX)], found);
  checkAxis("rows", rows, cardinality[index(Concept::kPositionY)], found);
  const std::size_t types = cardinality[index(Concept::kType)];
  const std::size_t sizes = cardinality[index(Concept::kSize)];
  const std::size_t rotations = cardinality[index(Concept::kRotation)];
  checkSize("footprints", types, footprints.size(), found);
  for (std::size_t type = 0; type < footprints.size(); ++type) {
    const std::string of_type = "footprints[" + std::to_string(type) + "]";
    checkSize(of_type, sizes, footprints[type].size(), found);
    for (std::size_t size = 0; size < footprints[type].size(); ++size) {
      const std::string of_size = of_type + "[" + std::to_string(size) + "]";
      checkSize(of_size, rotations, footprints[type][size].size(), found);
      for (std::size_t rotation = 0; rotation < footprints[type][size].size(); ++rotation) {
        checkFootprint(of_size + "[" + std::to_string(rotation) + "]",
                       footprints[type][size][rotation], found);
      }
    }
  }
  for (const Concept which : kConcepts) {
    if (names[index(which)].size() > cardinality[index(which)]) {
      found.push_back("names." + std::string(conceptplan::name(which)) + ": expected at most " +
                      std::to_string(cardinality[index(which)]) + " names, found " +
                      std::to_string(names[index(which)].size()));
    }
  }
  return found;
}

SymbolGrounding standardGrounding() {
  constexpr double kLargestRadius_m = 0.08;
  constexpr double kLargestHeight_m = 0.16;
  SymbolGrounding grounding;
  grounding.columns = {0, 1, 2};
  grounding.rows = {0, 1, 2, 3, 4};
  for (std::size_t type = 0; type < kNumSeenTypes; ++type) {
    grounding.names[index(Concept::kType)].emplace_back(
        conceptplan::name(static_cast<ObjectType>(type)));
    auto& of_type = grounding.footprints.emplace_back();
    for (int size = 0; size < 4; ++size) {
      of_type.emplace_back(4, Footprint{outlineOfDisc(kLargestRadius_m * sizeScale(size)),
                                        kLargestHeight_m * sizeScale(size)});
    }
  }
  for (int column = 0; column < 3; ++column) {
    grounding.names[index(Concept::kPositionX)].push_back("column " + std::to_string(column));
  }
  for (int row = 0; row < 5; ++row) {
    grounding.names[index(Concept::kPositionY)].push_back("row " + std::to_string(row));
  }
  grounding.names[index(Concept::kRotation)] = {"0 degrees", "90 degrees", "180 degrees",
                                                "270 degrees"};
  for (int color = 0; color < 6; ++color) {
    grounding.names[index(Concept::kColor)].emplace_back(colorName(color));
  }
  grounding.names[index(Concept::kSize)] = {"size 1 of 4", "size 2 of 4", "size 3 of 4",
                                            "size 4 of 4"};
  return grounding;
}

}  // namespace conceptplan
