#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

std::string_view name(Invalidity cause) {
  switch (cause) {
    case Invalidity::kNone:
      return "none";
    case Invalidity::kCollision:
      return "collision";
    case Invalidity::kWorkbenchEdge:
      return "workbench_edge";
    case Invalidity::kCheckFailed:
      break;
  }
  return "check_failed";
}

std::vector<Verdict> StateValidity::checkAll(const Workbench& workbench,
                                             const SymbolGrounding& grounding,
                                             std::span<const Symbols> targets,
                                             std::span<const Symbols> others) const {
  std::vector<Verdict> verdicts;
  verdicts.reserve(targets.size());
  for (const Symbols& target : targets) {
    verdicts.push_back(check(workbench, grounding, target, others));
  }
  return verdicts;
}

Verdict GridValidity::check(const Workbench& workbench, const SymbolGrounding& grounding,
                            const Symbols& target, std::span<const Symbols> others) const {
  const Cell cell = grounding.cell(target);
  if (!workbench.contains(cell)) return {Invalidity::kWorkbenchEdge, 0, 0};
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (grounding.cell(others[i]) == cell) return {Invalidity::kCollision, i, 0};
  }
  return {};
}

std::array<bool, kNumConcepts> GridValidity::dependsOn() const {
  std::array<bool, kNumConcepts> concepts{};
  concepts[index(Concept::kPositionX)] = true;
  concepts[index(Concept::kPositionY)] = true;
  return concepts;
}

}  // namespace conceptplan
