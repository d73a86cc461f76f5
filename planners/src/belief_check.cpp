#include "belief_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace conceptplan {
namespace {

constexpr double kSumTolerance = 1e-6;

}  // namespace

void checkBelief(const SymbolBelief& belief, const ConceptCardinality& cardinality,
                 const std::string& place) {
  for (const Concept which : kConcepts) {
    const std::vector<double>& row = belief[index(which)];
    const auto refuse = [&](const std::string& fault) {
      throw std::invalid_argument(place + ", " + std::string(name(which)) + ": " + fault);
    };
    if (row.size() != cardinality[index(which)]) {
      refuse("expected " + std::to_string(cardinality[index(which)]) + " symbols, found " +
             std::to_string(row.size()));
    }
    if (std::any_of(row.begin(), row.end(), [](double p) { return !(p >= 0); })) {
      refuse("a probability is negative or not a number");
    }
    const double sum = std::accumulate(row.begin(), row.end(), 0.0);
    if (!(std::abs(sum - 1) <= kSumTolerance)) {
      refuse("the probabilities sum to " + std::to_string(sum) + ", expected 1");
    }
  }
}

}  // namespace conceptplan
