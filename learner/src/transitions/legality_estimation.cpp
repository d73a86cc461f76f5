#include "legality_estimation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace conceptplan {
namespace {

/// Misreading never explains more than this share of the uses expected.
constexpr double kMostMisread = 0.5;
/// Where an action is legal it may yet be taken this many times less often than on average.
constexpr double kUsesIfLegal = 0.5;

double logLikelihood(double n, double total) { return n > 0 ? n * std::log(n / total) : 0; }

/// How often each action was taken at each value of a feature.
struct UseTable {
  std::vector<std::array<double, kNumActions>> uses;  ///< [value][action]
  std::vector<double> steps;                          ///< [value]
  std::array<double, kNumActions> all_uses{};
  double all_steps = 0;
};

UseTable countUses(const StepTable& table, const std::vector<std::size_t>& steps,
                   const ContextFeature& feature) {
  UseTable counts;
  const std::size_t values = valueCount(feature, table.cardinality());
  counts.uses.resize(values);
  counts.steps.resize(values, 0);
  const std::vector<std::uint16_t>& column = table.column(feature);
  for (const std::size_t step : steps) {
    if (isAbsent(feature, table.cardinality(), column[step])) continue;
    const std::size_t action = index(table.action(step));
    counts.uses[column[step]][action] += 1;
    counts.steps[column[step]] += 1;
    counts.all_uses[action] += 1;
    counts.all_steps += 1;
  }
  return counts;
}

/// By how much the table lowers BIC against one share for all values.
double bicGain(const UseTable& counts, Action action) {
  const double uses = counts.all_uses[index(action)];
  double gain = -logLikelihood(uses, counts.all_steps) -
                logLikelihood(counts.all_steps - uses, counts.all_steps);
  double seen = 0;
  for (std::size_t value = 0; value < counts.steps.size(); ++value) {
    if (counts.steps[value] == 0) continue;
    seen += 1;
    const double here = counts.uses[value][index(action)];
    gain += logLikelihood(here, counts.steps[value]) +
            logLikelihood(counts.steps[value] - here, counts.steps[value]);
  }
  return 2 * gain - (seen - 1) * std::log(std::max(counts.all_steps, 1.0));
}

/// The probability that some symbol of the feature was misread.
double misreadRate(const ContextFeature& feature,
                   const std::array<double, kNumConcepts>& misread_rate) {
  if (feature.kind == ContextKind::kOwnSymbol) return misread_rate[index(feature.which)];
  const double x = 1 - misread_rate[index(Concept::kPositionX)];
  const double y = 1 - misread_rate[index(Concept::kPositionY)];
  return 1 - x * x * y * y * (1 - misread_rate[index(Concept::kType)]);
}

/// What the steps at one value of a feature tell of one action.
struct Use {
  double expected = 0;  ///< uses, if the feature meant nothing
  double uses = 0;      ///< less those that misreading explains
};

Use useOf(const UseTable& counts, std::size_t value, std::size_t action, double misread) {
  if (counts.all_steps == 0) return {};
  const double expected = counts.all_uses[action] / counts.all_steps * counts.steps[value];
  return {expected, std::max(0.0, counts.uses[value][action] - misread * expected)};
}

/// The probability that the action is legal at a value where it was never taken.
/// @param prior of values at which it is not legal.
double legalThoughUnused(const Use& use, double prior) {
  const double chance = (1 - prior) * std::exp(-kUsesIfLegal * use.expected);
  return chance / (prior + chance);
}

/// The share of the values at which the action is not legal, from those that tell.
double illegalShare(const std::vector<Use>& uses, double threshold) {
  double used = 0;
  double ruled_out = 0;
  for (const Use& use : uses) {
    if (use.uses > 0) used += 1;
    if (use.uses == 0 && legalThoughUnused(use, 0.5) * ActionLegality::kPriorShare <= threshold) {
      ruled_out += 1;
    }
  }
  return (ruled_out + 0.5) / (ruled_out + used + 1);
}

/// Pr[a | value] with all actions weighed alike: the action's uses as a multiple of those expected,
/// over the same of all actions; where it was never taken, the prior share times the probability
/// that it is legal nevertheless.
std::vector<double> shares(const UseTable& counts, Action action, double misread,
                           const TransitionEstimationOptions& options) {
  std::vector<Use> uses;
  for (std::size_t value = 0; value < counts.steps.size(); ++value) {
    uses.push_back(useOf(counts, value, index(action), misread));
  }
  const double illegal = illegalShare(uses, options.legality_threshold);
  std::vector<double> share(counts.steps.size(), ActionLegality::kPriorShare);
  for (std::size_t value = 0; value < share.size(); ++value) {
    if (counts.steps[value] == 0) continue;
    if (uses[value].uses == 0) {
      share[value] *= legalThoughUnused(uses[value], illegal);
      continue;
    }
    const auto multiple = [&](std::size_t a) {
      const Use use = useOf(counts, value, a, misread);
      return (use.uses + options.prior_uses) / (use.expected + options.prior_uses);
    };
    double all = 0;
    for (std::size_t a = 0; a < kNumActions; ++a) all += multiple(a);
    share[value] = multiple(index(action)) / all;
  }
  return share;
}

ContextCounts evidence(const UseTable& counts, const ContextFeature& feature, Action action) {
  ContextCounts result{{feature}, {}};
  for (std::size_t value = 0; value < counts.steps.size(); ++value) {
    if (counts.steps[value] == 0) continue;
    const double uses = counts.uses[value][index(action)];
    result.rows[value] = {counts.steps[value] - uses, uses};
  }
  return result;
}

}  // namespace

LegalityEstimate estimateLegality(const StepTable& table, Action action,
                                  const std::array<double, kNumConcepts>& misread_rate,
                                  const TransitionEstimationOptions& options) {
  std::vector<ContextFeature> candidates = ownSymbolFeatures(Concept::kType);
  for (const ContextFeature& feature :
       nearestFeatures(ContextKind::kNearestOffset, Concept::kType, table.cardinality())) {
    candidates.push_back(feature);
  }
  std::vector<std::size_t> steps(table.size());
  std::iota(steps.begin(), steps.end(), std::size_t{0});

  LegalityEstimate estimate;
  while (estimate.factors.size() < options.max_legality_factors) {
    std::optional<LegalityFactor> best;
    UseTable best_counts;
    double most = 0;
    for (const ContextFeature& candidate : candidates) {
      UseTable counts = countUses(table, steps, candidate);
      const double gain = bicGain(counts, action);
      if (gain <= most) continue;
      const double misread =
          std::min(kMostMisread, options.misread_slack * misreadRate(candidate, misread_rate));
      std::vector<double> share = shares(counts, action, misread, options);
      if (*std::min_element(share.begin(), share.end()) > options.legality_threshold) continue;
      most = gain;
      best = LegalityFactor{candidate, std::move(share)};
      best_counts = std::move(counts);
    }
    if (!best) break;
    const std::vector<std::uint16_t>& column = table.column(best->context);
    std::erase_if(steps, [&](std::size_t step) {
      return best->share[column[step]] <= options.legality_threshold;
    });
    estimate.counts.push_back(evidence(best_counts, best->context, action));
    estimate.factors.push_back(std::move(*best));
  }
  return estimate;
}

}  // namespace conceptplan
