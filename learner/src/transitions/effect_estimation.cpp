#include "effect_estimation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace conceptplan {
namespace {

using Rows = std::map<std::size_t, std::vector<double>>;

double sum(const std::vector<double>& row) { return std::accumulate(row.begin(), row.end(), 0.0); }

/// n log(n / total), 0 for n = 0.
double logLikelihood(double n, double total) { return n > 0 ? n * std::log(n / total) : 0; }

double bic(double log_likelihood, double parameters, double steps) {
  return -2 * log_likelihood + parameters * std::log(std::max(steps, 1.0));
}

/// The steps of one action, as the table of one concept's effect is fitted to them.
class EffectFit {
 public:
  EffectFit(const StepTable& table, std::vector<std::size_t> steps, Concept which)
      : table_(table), steps_(std::move(steps)), joint_(steps_.size(), 0), which_(which) {}

  const std::vector<ContextFeature>& context() const { return context_; }

  /// Adds the candidate that lowers BIC most; false if none lowers it.
  bool grow(const std::vector<ContextFeature>& candidates) {
    const ContextFeature* best = nullptr;
    double least = tableBic(rowsWith(nullptr));
    for (const ContextFeature& candidate : candidates) {
      const double value = tableBic(rowsWith(&candidate));
      if (value < least) {
        least = value;
        best = &candidate;
      }
    }
    if (best == nullptr) return false;
    extend(*best);
    return true;
  }

  Rows rows() const { return rowsWith(nullptr); }
  double tableBic() const { return tableBic(rows()); }

  /// BIC of the model in which the symbol stays with one probability, on the same steps.
  double stayBic() const {
    const auto steps = static_cast<double>(steps_.size());
    const double stay = stayCount();
    const double others = std::max(1.0, static_cast<double>(symbols() - 1));
    return bic(logLikelihood(stay, steps) + logLikelihood(steps - stay, steps) -
                   (steps - stay) * std::log(others),
               1, steps);
  }

  double stayCount() const {
    return static_cast<double>(std::count_if(steps_.begin(), steps_.end(), [&](std::size_t step) {
      return table_.symbolBefore(step, which_) == table_.symbolAfter(step, which_);
    }));
  }

  double steps() const { return static_cast<double>(steps_.size()); }

 private:
  std::size_t symbols() const { return table_.cardinality()[index(which_)]; }

  std::size_t jointWith(std::size_t i, const ContextFeature* candidate) const {
    if (candidate == nullptr) return joint_[i];
    return joint_[i] * valueCount(*candidate, table_.cardinality()) +
           table_.column(*candidate)[steps_[i]];
  }

  Rows rowsWith(const ContextFeature* candidate) const {
    Rows rows;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      std::vector<double>& row = rows[jointWith(i, candidate)];
      row.resize(symbols(), 0);
      row[table_.symbolAfter(steps_[i], which_)] += 1;
    }
    return rows;
  }

  double tableBic(const Rows& rows) const {
    double log_likelihood = 0;
    for (const auto& [joint, row] : rows) {
      const double total = sum(row);
      for (const double count : row) log_likelihood += logLikelihood(count, total);
    }
    const auto parameters = static_cast<double>(rows.size() * (symbols() - 1));
    return bic(log_likelihood, parameters, steps());
  }

  /// Steps without the object of the feature are set aside.
  void extend(const ContextFeature& feature) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (table_.isAbsent(feature, steps_[i])) continue;
      joint_[kept] = jointWith(i, &feature);
      steps_[kept++] = steps_[i];
    }
    steps_.resize(kept);
    joint_.resize(kept);
    context_.push_back(feature);
  }

  const StepTable& table_;
  std::vector<std::size_t> steps_;
  std::vector<std::size_t> joint_;  // value of the context in each step
  Concept which_;
  std::vector<ContextFeature> context_;
};

/// Probability, or 0 or 1 where only misread symbols stand against certainty.
double withoutMisread(double probability, double misread_share) {
  if (probability < misread_share) return 0;
  return probability > 1 - misread_share ? 1 : probability;
}

/// The own symbol that a context value tells, if it tells one.
std::optional<std::size_t> ownSymbol(const std::vector<ContextFeature>& context, Concept which,
                                     const ConceptCardinality& cardinality, std::size_t joint) {
  const std::vector<std::size_t> values = splitJointValue(context, cardinality, joint);
  for (std::size_t i = 0; i < context.size(); ++i) {
    if (context[i].kind == ContextKind::kOwnSymbol && context[i].which == which) return values[i];
  }
  return std::nullopt;
}

/// The distribution of one row, with misread outcomes taken out and counted.
std::vector<double> distributionOf(std::vector<double> counts, std::optional<std::size_t> own,
                                   const TransitionEstimationOptions& options, double& misread) {
  std::vector<double> row = counts;
  if (own) row[*own] += options.stay_steps;
  const double total = sum(row);
  const double most = *std::max_element(row.begin(), row.end());
  for (std::size_t symbol = 0; symbol < row.size(); ++symbol) {
    if (row[symbol] < most && row[symbol] < options.misread_share * total) {
      misread += counts[symbol];
      row[symbol] = 0;
    }
  }
  const double kept = sum(row);
  for (double& probability : row) probability /= kept;
  return row;
}

}  // namespace

EffectEstimate estimateEffect(const StepTable& table, const std::vector<std::size_t>& steps,
                              Concept which, const TransitionEstimationOptions& options) {
  EffectEstimate estimate;
  estimate.steps = static_cast<double>(steps.size());
  if (steps.empty()) return estimate;
  std::vector<ContextFeature> candidates = ownSymbolFeatures(which);
  for (const ContextFeature& feature :
       nearestFeatures(ContextKind::kNearestSymbol, which, table.cardinality())) {
    candidates.push_back(feature);
  }
  EffectFit fit(table, steps, which);
  while (fit.context().size() < options.max_effect_features && fit.grow(candidates)) {
  }
  if (fit.stayBic() <= fit.tableBic()) {
    const EffectFit all(table, steps, which);
    const double share = all.stayCount() / all.steps();
    estimate.effect.stays = withoutMisread(share, options.misread_share);
    if (estimate.effect.stays == 1) estimate.misread = all.steps() - all.stayCount();
    if (estimate.effect.stays == 0) estimate.misread = all.stayCount();
    estimate.counts.rows = all.rows();
    return estimate;
  }
  estimate.effect.context = fit.context();
  estimate.counts.context = fit.context();
  estimate.counts.rows = fit.rows();
  for (const auto& [joint, counts] : estimate.counts.rows) {
    estimate.effect.rows[joint] =
        distributionOf(counts, ownSymbol(fit.context(), which, table.cardinality(), joint), options,
                       estimate.misread);
  }
  return estimate;
}

}  // namespace conceptplan
