#include "conceptplan/planners/state_validity.hpp"

#include <algorithm>
#include <map>

namespace conceptplan {

static_assert(sizeof(Verdict) == 16);

namespace {

/// @param met the object in the cell; `objects` if there is none.
Verdict verdictAt(const Workbench& workbench, Cell cell, std::size_t met, std::size_t objects) {
  if (!workbench.contains(cell)) return {Invalidity::kWorkbenchEdge, 0, 0};
  if (met < objects) return {Invalidity::kCollision, static_cast<std::uint32_t>(met), 0};
  return {};
}

}  // namespace

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
  const auto met = std::find_if(others.begin(), others.end(), [&](const Symbols& other) {
    return grounding.cell(other) == cell;
  });
  return verdictAt(workbench, cell, static_cast<std::size_t>(met - others.begin()), others.size());
}

std::vector<Verdict> GridValidity::checkAll(const Workbench& workbench,
                                            const SymbolGrounding& grounding,
                                            std::span<const Symbols> targets,
                                            std::span<const Symbols> others) const {
  std::map<Cell, std::size_t> taken;  // by the first object of those in the cell
  for (std::size_t i = 0; i < others.size(); ++i) taken.emplace(grounding.cell(others[i]), i);
  std::vector<Verdict> verdicts;
  verdicts.reserve(targets.size());
  for (const Symbols& target : targets) {
    const Cell cell = grounding.cell(target);
    const auto met = taken.find(cell);
    verdicts.push_back(verdictAt(workbench, cell, met == taken.end() ? others.size() : met->second,
                                 others.size()));
  }
  return verdicts;
}

std::array<bool, kNumConcepts> GridValidity::dependsOn() const {
  std::array<bool, kNumConcepts> concepts{};
  concepts[index(Concept::kPositionX)] = true;
  concepts[index(Concept::kPositionY)] = true;
  return concepts;
}

}  // namespace conceptplan
