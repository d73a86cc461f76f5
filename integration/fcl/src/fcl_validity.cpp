#include "conceptplan/fcl/fcl_validity.hpp"

#include <stdexcept>
#include <string>

#include "prism_shapes.hpp"

namespace conceptplan {

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
  std::vector<Verdict> verdicts;
  verdicts.reserve(targets.size());
  for (const Symbols& target : targets) {
    verdicts.push_back(
        scene.check(prismOf(workbench, grounding, target, options_.max_half_width_cells)));
  }
  return verdicts;
}

Verdict FclValidity::checkMotion(const Workbench& workbench, const SymbolGrounding& grounding,
                                 const Symbols& from, const Symbols& to,
                                 std::span<const Symbols> others) const {
  UprightPrism target = prismOf(workbench, grounding, from, options_.max_half_width_cells);
  const UprightPrism there = prismOf(workbench, grounding, to, options_.max_half_width_cells);
  target.outline = unionOf(target.outline, there.outline);
  return sceneOf(workbench, grounding, others).checkMotion(target, there.p_WCentre);
}

FclScene FclValidity::sceneOf(const Workbench& workbench, const SymbolGrounding& grounding,
                              std::span<const Symbols> others) const {
  std::vector<UprightPrism> prisms;
  for (const Symbols& other : others) {
    prisms.push_back(prismOf(workbench, grounding, other, options_.max_half_width_cells));
  }
  return {workbench, std::move(prisms), options_.margin_m, shapes_};
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
