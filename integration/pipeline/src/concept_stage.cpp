#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "step_loop.hpp"

namespace conceptplan::training {

std::vector<Work> conceptWork() {
  return {{"data: concepts-train", 0.8}, {"reading concepts-train", 0.2}, {"concepts", 70}};
}

bool trainConcepts(const Run& run, ModelManifest&) {
  const auto data = conceptData(run, Split::kTrain);
  if (!data) return false;
  ConceptImages images;
  for (std::size_t i = 0; i < data->size(); ++i) {
    if (run.cancelled()) return false;
    const ConceptSample sample = data->sample(i);
    images.add(encoderInput(sample.crop), conceptValues(sample.object));
    if (i % 500 == 0) run.report({"reading concepts-train", i, data->size(), ""});
  }
  ConceptTrainingOptions options = run.profile.concepts;
  const auto start = run.options.start_from / kConceptsFile;
  const bool starts_from = !run.options.start_from.empty();
  if (starts_from) options.start_from = hexadecimal(crc32OfFile(start));
  ConceptTrainer trainer(images, options);
  if (starts_from) trainer.startFrom(decodeTensors(readFile(start), start), start);
  const auto describe = [](const ConceptLosses& losses) {
    return nlohmann::ordered_json{{"disentangling", losses.disentangling},
                                  {"pair", losses.pair},
                                  {"use", losses.use},
                                  {"confidence", losses.confidence},
                                  {"reconstruction", losses.reconstruction},
                                  {"direct", losses.direct},
                                  {"location", losses.location},
                                  {"sharpness", losses.sharpness},
                                  {"box", losses.box},
                                  {"reading", losses.reading}}
        .dump();
  };
  // 3,400 of the profile's 8,400 steps teach tokens, and take 63 % of the time.
  constexpr double kTokenStepCost = 2.5;
  const auto phases_of = [&trainer] { return Phases{trainer.tokenSteps(), kTokenStepCost}; };
  if (!runSteps(run, TrainingStage::kLearnConcepts, trainer, phases_of, describe)) return false;
  writeFileAtomically(
      run.options.model / kConceptsFile,
      encodeTensors(tensorsOf(*trainer.averaged(), "concepts."), TensorPrecision::kFloat16));
  return true;
}

}  // namespace conceptplan::training
