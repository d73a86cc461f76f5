#include "conceptplan/pipeline/concept_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "conceptplan/domain/input_error.hpp"
#include "token_measures.hpp"
#include "torch_threads.hpp"

namespace conceptplan {
namespace {

/// Tokens and true values of pictures, in the order of the set.
struct Readings {
  std::vector<Tokens> tokens;
  std::vector<ConceptValues> values;
  std::vector<bool> recognised;  ///< see `Model::recognises`
};

Readings readAll(const ConceptDataset& data, const Model& model,
                 const ConceptEvaluationOptions& options) {
  constexpr std::size_t kBatch = 256;  // what is decoded at once
  const TorchThreads one_thread(1);
  Readings readings;
  std::vector<EncoderInput> inputs;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (options.cancel != nullptr && *options.cancel) return {};
    const ConceptSample sample = data.sample(i);
    inputs.push_back(encoderInput(sample.crop));
    readings.values.push_back(conceptValues(sample.object));
    if (inputs.size() < kBatch && i + 1 < data.size()) continue;
    const std::vector<Tokens> tokens = model.learner().encode(inputs);
    readings.tokens.insert(readings.tokens.end(), tokens.begin(), tokens.end());
    const std::vector<DrawnObject> drawn = model.learner().draw(tokens);
    for (std::size_t k = 0; k < inputs.size(); ++k)
      readings.recognised.push_back(
          pictureResidual(inputs[k], drawn[k]).within(model.symbols().most_residual));
    inputs.clear();
    if (options.progress) options.progress(i + 1, data.size());
  }
  return readings;
}

}  // namespace

void requireSameSplit(const ConceptDataset& data, const Model& model) {
  const std::uint64_t trained = model.manifest().seed, drawn = data.options().seed;
  if (trained == drawn) return;
  throw InputError({{(data.folder() / "dataset.json").string(), std::nullopt, std::nullopt, "seed",
                     "expected " + std::to_string(trained) + ", found " + std::to_string(drawn) +
                         ": the model's training may have seen these combinations; generate the "
                         "set with --seed " +
                         std::to_string(trained)}});
}

ConceptEvaluation evaluateConcepts(const ConceptDataset& data, const Model& model,
                                   const ConceptEvaluationOptions& options) {
  requireSameSplit(data, model);
  ConceptEvaluation evaluation;
  evaluation.set =
      std::string(name(data.options().split)) + "/" + std::string(name(data.options().domain));
  const Readings readings = readAll(data, model, options);
  const std::size_t count = readings.tokens.size();
  if (count == 0) return evaluation;
  std::array<std::vector<double>, kNumConcepts> confidence;
  std::array<std::vector<bool>, kNumConcepts> right;
  double all_right = 0, fit_no_symbol = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const SymbolBelief belief = model.symbols().symbolizer.belief(readings.tokens[i]);
    if (isLikeNoneLearned(model.symbols().symbolizer.fits(readings.tokens[i]),
                          readings.recognised[i]))
      fit_no_symbol += 1;
    bool all = true;
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      const auto best = std::max_element(belief[k].begin(), belief[k].end());
      const auto symbol = static_cast<std::size_t>(best - belief[k].begin());
      confidence[k].push_back(*best);
      right[k].push_back(model.symbols().values[k][symbol] == readings.values[i][k]);
      all = all && right[k].back();
    }
    all_right += all ? 1 : 0;
  }
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    evaluation.accuracy[k] =
        static_cast<double>(std::count(right[k].begin(), right[k].end(), true)) /
        static_cast<double>(count);
    evaluation.calibration_error[k] = calibrationError(confidence[k], right[k]);
  }
  evaluation.pictures = count;
  evaluation.all_right = all_right / static_cast<double>(count);
  evaluation.fit_no_symbol = fit_no_symbol / static_cast<double>(count);
  evaluation.disentanglement = tokenScores(readings.tokens, readings.values, options.seed);
  return evaluation;
}

}  // namespace conceptplan
