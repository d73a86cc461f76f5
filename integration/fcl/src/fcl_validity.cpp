#include "conceptplan/fcl/fcl_validity.hpp"

#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "prism_shapes.hpp"

namespace conceptplan {
namespace {

/// Prisms of the symbols of one grounding. Few footprints serve many symbols, so each is clipped
/// once.
class Prisms {
 public:
  Prisms(const Workbench& workbench, const SymbolGrounding& grounding, double max_half_width_cells)
      : workbench_(workbench), grounding_(grounding), max_half_width_cells_(max_half_width_cells) {}

  UprightPrism operator()(const Symbols& symbols) {
    const auto [known, is_new] = clipped_.try_emplace(&grounding_.footprint(symbols));
    if (is_new) known->second = prismOf(workbench_, grounding_, symbols, max_half_width_cells_);
    UprightPrism prism = known->second;
    prism.p_WCentre = workbench_.p_WCell(grounding_.cell(symbols));
    return prism;
  }

 private:
  const Workbench& workbench_;
  const SymbolGrounding& grounding_;
  double max_half_width_cells_;
  std::unordered_map<const Footprint*, UprightPrism> clipped_;
};

}  // namespace

FclValidity::FclValidity(const FclValidityOptions& options)
    : options_(options), shapes_(std::make_shared<PrismShapes>()) {
  if (!(options.margin_m > 0)) {
    throw std::invalid_argument("margin_m is " + std::to_string(options.margin_m) +
                                ", expected > 0");
  }
  if (!(options.max_half_width_cells > 0 && options.max_half_width_cells < 0.5)) {
    throw std::invalid_argument("max_half_width_cells is " +
                                std::to_string(options.max_half_width_cells) +
                                ", expected a number in (0, 0.5)");
  }
}

Verdict FclValidity::check(const Workbench& workbench, const SymbolGrounding& grounding,
                           const Symbols& target, std::span<const Symbols> others) const {
  return checkMotion(workbench, grounding, target, target, others);
}

std::vector<Verdict> FclValidity::checkAll(const Workbench& workbench,
                                           const SymbolGrounding& grounding,
                                           std::span<const Symbols> targets,
                                           std::span<const Symbols> others) const {
  const FclScene scene = sceneOf(workbench, grounding, others);
  Prisms prisms(workbench, grounding, options_.max_half_width_cells);
  std::vector<Verdict> verdicts;
  verdicts.reserve(targets.size());
  for (const Symbols& target : targets) verdicts.push_back(scene.check(prisms(target)));
  return verdicts;
}

Verdict FclValidity::checkMotion(const Workbench& workbench, const SymbolGrounding& grounding,
                                 const Symbols& from, const Symbols& to,
                                 std::span<const Symbols> others) const {
  Prisms prisms(workbench, grounding, options_.max_half_width_cells);
  UprightPrism target = prisms(from);
  const UprightPrism there = prisms(to);
  target.outline = unionOf(target.outline, there.outline);
  return sceneOf(workbench, grounding, others).checkMotion(target, there.p_WCentre);
}

FclScene FclValidity::sceneOf(const Workbench& workbench, const SymbolGrounding& grounding,
                              std::span<const Symbols> others) const {
  Prisms prisms(workbench, grounding, options_.max_half_width_cells);
  std::vector<UprightPrism> standing;
  standing.reserve(others.size());
  for (const Symbols& other : others) standing.push_back(prisms(other));
  return {workbench, std::move(standing), options_.margin_m, shapes_};
}

std::array<bool, kNumConcepts> FclValidity::dependsOn() const {
  std::array<bool, kNumConcepts> concepts{};
  for (const Concept which : {Concept::kType, Concept::kPositionX, Concept::kPositionY,
                              Concept::kRotation, Concept::kSize}) {
    concepts[index(which)] = true;
  }
  return concepts;
}

}  // namespace conceptplan
