#include "conceptplan/domain/model/action_legality.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace conceptplan {

ActionLegality::ActionLegality(const ConceptCardinality& cardinality, LegalityTable factors)
    : cardinality_(cardinality), factors_(std::move(factors)) {
  for (const Action action : kActions) {
    for (const LegalityFactor& factor : factors_[index(action)]) {
      const std::string place = "legality of " + std::string(name(action)) + ": ";
      const std::size_t values = valueCount(factor.context, cardinality_);
      if (factor.share.size() != values) {
        throw std::invalid_argument(place + "a factor has " + std::to_string(factor.share.size()) +
                                    " shares, expected " + std::to_string(values));
      }
      for (const double share : factor.share) {
        if (!(share >= 0 && share <= 1)) {
          throw std::invalid_argument(place + "share " + std::to_string(share) +
                                      " is not in [0, 1]");
        }
      }
    }
  }
}

double ActionLegality::probability(Action action, const Surroundings& surroundings) const {
  const std::vector<LegalityFactor>& all = factors(action);
  if (all.empty()) return kPriorShare;
  double least = 1;
  for (const LegalityFactor& factor : all) {
    least = std::min(least, factor.share[valueOf(factor.context, cardinality_, surroundings)]);
  }
  return least;
}

}  // namespace conceptplan
