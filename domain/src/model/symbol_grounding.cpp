#include "conceptplan/domain/model/symbol_grounding.hpp"

#include <cmath>

namespace conceptplan {
namespace {

void checkAxis(const char* what, const std::vector<int>& cells, std::size_t symbols,
               std::vector<std::string>& faults) {
  if (cells.size() != symbols) {
    faults.push_back(std::string(what) + ": expected " + std::to_string(symbols) +
                     " entries, found " + std::to_string(cells.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] < 0) {
      faults.push_back(std::string(what) + "[" + std::to_string(i) +
                       "]: expected a cell index >= 0, found " + std::to_string(cells[i]));
    }
  }
}

bool isLength(double value_m) { return std::isfinite(value_m) && value_m > 0; }

}  // namespace

Cell SymbolGrounding::cell(const Symbols& symbols) const {
  return {columns[index(symbols[index(Concept::kPositionX)])],
          rows[index(symbols[index(Concept::kPositionY)])]};
}

const Footprint& SymbolGrounding::footprint(const Symbols& symbols) const {
  return footprints[index(symbols[index(Concept::kType)])][index(symbols[index(Concept::kSize)])];
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
  if (footprints.size() != types) {
    found.push_back("footprints: expected " + std::to_string(types) + " rows, found " +
                    std::to_string(footprints.size()));
  }
  for (std::size_t type = 0; type < footprints.size(); ++type) {
    const std::string row = "footprints[" + std::to_string(type) + "]";
    if (footprints[type].size() != sizes) {
      found.push_back(row + ": expected " + std::to_string(sizes) + " entries, found " +
                      std::to_string(footprints[type].size()));
    }
    for (const Footprint& footprint : footprints[type]) {
      if (!isLength(footprint.radius_m) || !isLength(footprint.height_m)) {
        found.push_back(row + ": expected radius and height > 0 m, found " +
                        std::to_string(footprint.radius_m) + " and " +
                        std::to_string(footprint.height_m));
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
    std::vector<Footprint>& row = grounding.footprints.emplace_back();
    for (int size = 0; size < 4; ++size) {
      row.push_back({kLargestRadius_m * sizeScale(size), kLargestHeight_m * sizeScale(size)});
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
