#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/symbols.hpp"
#include "conceptplan/domain/workbench.hpp"

namespace conceptplan {

/// Why a state cannot be.
enum class Invalidity : std::uint8_t {
  kNone,           ///< it can be
  kCollision,      ///< the target meets another object
  kWorkbenchEdge,  ///< the target is not wholly on the workbench
  kCheckFailed     ///< the check itself failed; the state counts as invalid
};

/// "none", "collision", "workbench_edge", "check_failed".
std::string_view name(Invalidity cause);

/// The answer of a validity check; 16 bytes, since graphs have one a cell.
struct Verdict {
  Invalidity cause = Invalidity::kNone;
  std::uint32_t object = 0;  ///< which of `others` is met; only for kCollision
  double clearance_m = 0;    ///< distance to what is nearest where the check measures it; else 0

  bool valid() const { return cause == Invalidity::kNone; }
  bool operator==(const Verdict&) const = default;
};

/// Tells which symbols of the target are possible among other objects: Omega_valid of Eq. (6),
/// the third belief equation of Sec. III-B of arXiv 2310.03325. Implementations are thread-safe.
class StateValidity {
 public:
  virtual ~StateValidity() = default;

  /// @pre all symbols are below the cardinality of the grounding.
  virtual Verdict check(const Workbench& workbench, const SymbolGrounding& grounding,
                        const Symbols& target, std::span<const Symbols> others) const = 0;

  /// `check` of each target among the same others, [targets]; for checks that can do all at once
  /// faster.
  virtual std::vector<Verdict> checkAll(const Workbench& workbench,
                                        const SymbolGrounding& grounding,
                                        std::span<const Symbols> targets,
                                        std::span<const Symbols> others) const;

  /// The concepts of the target on which the answer depends; one check serves all states that
  /// agree in them.
  virtual std::array<bool, kNumConcepts> dependsOn() const = 0;
};

/// Validity on cells alone, without geometry: a state is invalid where the target stands in the
/// cell of another object or beside the workbench.
class GridValidity final : public StateValidity {
 public:
  Verdict check(const Workbench& workbench, const SymbolGrounding& grounding, const Symbols& target,
                std::span<const Symbols> others) const override;
  std::vector<Verdict> checkAll(const Workbench& workbench, const SymbolGrounding& grounding,
                                std::span<const Symbols> targets,
                                std::span<const Symbols> others) const override;
  std::array<bool, kNumConcepts> dependsOn() const override;
};

}  // namespace conceptplan
