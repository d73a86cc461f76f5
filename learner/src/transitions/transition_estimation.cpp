#include "conceptplan/learner/transitions/transition_estimation.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "effect_estimation.hpp"
#include "legality_estimation.hpp"
#include "step_table.hpp"

namespace conceptplan {
namespace {

void checkOptions(const TransitionEstimationOptions& options) {
  const auto check = [](bool fits, const char* option, double value) {
    if (!fits) {
      throw std::invalid_argument(std::string(option) + " is " + std::to_string(value) +
                                  ", which is out of range");
    }
  };
  check(options.misread_share >= 0 && options.misread_share < 0.5, "misread_share",
        options.misread_share);
  check(options.stay_steps >= 0, "stay_steps", options.stay_steps);
  check(options.prior_uses > 0, "prior_uses", options.prior_uses);
  check(options.legality_threshold >= 0 && options.legality_threshold <= 1, "legality_threshold",
        options.legality_threshold);
  check(options.misread_floor >= 0 && options.misread_floor <= 1, "misread_floor",
        options.misread_floor);
  check(options.misread_slack >= 0, "misread_slack", options.misread_slack);
}

void checkGrounding(const SymbolGrounding& grounding, const ConceptCardinality& cardinality) {
  std::string text;
  for (const std::string& fault : grounding.faults(cardinality)) text += "; " + fault;
  if (!text.empty()) throw std::invalid_argument("grounding" + text);
}

}  // namespace

SymbolicModel estimateSymbolicModel(std::span<const Triplet> triplets,
                                    const SymbolGrounding& grounding,
                                    const ConceptCardinality& cardinality,
                                    const TransitionEstimationOptions& options) {
  checkOptions(options);
  if (triplets.empty()) throw std::invalid_argument("there are no triplets to learn from");
  checkGrounding(grounding, cardinality);
  const StepTable table(triplets, grounding, cardinality);

  std::array<std::vector<std::size_t>, kNumActions> steps;
  for (std::size_t step = 0; step < table.size(); ++step) {
    steps[index(table.action(step))].push_back(step);
  }
  EffectTable effects;
  ModelEvidence evidence;
  std::array<double, kNumConcepts> misread{};
  for (const Action action : kActions) {
    evidence.steps[index(action)] = static_cast<double>(steps[index(action)].size());
    for (const Concept which : kConcepts) {
      EffectEstimate estimate = estimateEffect(table, steps[index(action)], which, options);
      // A step is misread if the symbol before or the one after is.
      misread[index(which)] += estimate.misread / 2;
      effects[index(action)][index(which)] = std::move(estimate.effect);
      evidence.transitions[index(action)][index(which)] = std::move(estimate.counts);
    }
  }
  for (double& rate : misread) {
    rate = std::max(options.misread_floor, rate / static_cast<double>(table.size()));
  }

  LegalityTable legality;
  for (const Action action : kActions) {
    LegalityEstimate estimate = estimateLegality(table, action, misread, options);
    legality[index(action)] = std::move(estimate.factors);
    evidence.legality[index(action)] = std::move(estimate.counts);
  }
  return {grounding, TransitionModel(cardinality, std::move(effects)),
          ActionLegality(cardinality, std::move(legality)), std::move(evidence)};
}

}  // namespace conceptplan
