#pragma once

#include <array>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/model/context_feature.hpp"

namespace conceptplan {

/// Pr[a | value of one feature], for each value.
struct LegalityFactor {
  ContextFeature context;
  std::vector<double> share;  ///< [value count of the context], in [0, 1]

  bool operator==(const LegalityFactor&) const = default;
};

using LegalityTable = std::array<std::vector<LegalityFactor>, kNumActions>;

/// Pr[a | Omega], on which action legality rests: the least of the selected factors, so that one
/// context in which an action was never taken is enough to rule it out. Without factors an action
/// has the share 1 / 7. Immutable. Source: Sec. III-B, "action legality", and Eq. (5),
/// eq:mdpsigma2, of arXiv 2310.03325.
class ActionLegality {
 public:
  /// Share of an action of which nothing is known: all seven weigh the same.
  static constexpr double kPriorShare = 1.0 / kNumActions;

  /// @throws std::invalid_argument if a factor has another number of values than its context, or
  /// a share outside [0, 1].
  ActionLegality(const ConceptCardinality& cardinality, LegalityTable factors);

  const std::vector<LegalityFactor>& factors(Action action) const {
    return factors_[index(action)];
  }

  /// Pr[a | Omega] in [0, 1].
  double probability(Action action, const Surroundings& surroundings) const;

  bool operator==(const ActionLegality&) const = default;

 private:
  ConceptCardinality cardinality_;
  LegalityTable factors_;
};

}  // namespace conceptplan
