#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "step_loop.hpp"

namespace conceptplan::training {

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
  ConceptTrainer trainer(images, run.profile.concepts);
  if (!run.options.start_from.empty()) {
    const auto path = run.options.start_from / kConceptsFile;
    trainer.startFrom(decodeTensors(readFile(path), path), path);
  }
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
  if (!runSteps(run, TrainingStage::kLearnConcepts, trainer, trainer.stepsInAll(), describe))
    return false;
  writeFileAtomically(
      run.options.model / kConceptsFile,
      encodeTensors(tensorsOf(*trainer.averaged(), "concepts."), TensorPrecision::kFloat16));
  return true;
}

}  // namespace conceptplan::training
