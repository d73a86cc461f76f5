#include "conceptplan/pipeline/training.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/domain/files/nearest_name.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "torch_threads.hpp"
#include "training_stages.hpp"

namespace conceptplan {
namespace training {
namespace {

Profile cpuProfile() {
  Profile profile;
  profile.name = "cpu";
  return profile;
}

Profile paperProfile() {
  Profile profile = cpuProfile();
  profile.name = "paper";
  profile.concepts = paperConceptTraining();
  return profile;
}

Profile smokeProfile() {
  Profile profile;
  profile.name = "smoke";
  profile.concept_samples = 1;
  profile.tasks_per_level = 2;
  profile.symbol_images = 400;
  profile.validation_images = 240;
  profile.checkpoint_interval = std::chrono::seconds(0);
  profile.concepts.encoder_steps = 2;
  profile.concepts.most_repairs = 0;
  profile.concepts.sharpening_steps = 1;
  profile.concepts.drawer_steps = 1;
  profile.concepts.chains = 2;
  profile.concepts.drawer_chains = 1;
  profile.concepts.reconstructed_pairs = 2;
  profile.vict.transition_steps = 4;
  profile.vict.transition_batch = 8;
  profile.vict.synthesis_steps = 4;
  profile.vict.synthesis_batch = 2;
  return profile;
}

/// The same data as `smoke`, of which fewer pictures are read: whole frames take longer.
Profile smokePaperProfile() {
  Profile profile = smokeProfile();
  profile.name = "smoke-paper";
  profile.symbol_images = 80;
  profile.validation_images = 80;
  profile.concepts = paperConceptTraining();
  profile.concepts.encoder_steps = 2;
  profile.concepts.chains = 1;
  profile.concepts.reconstructed_pairs = 1;
  return profile;
}

}  // namespace

Profile profileNamed(const std::string& name) {
  for (Profile profile : {cpuProfile(), paperProfile(), smokeProfile(), smokePaperProfile()})
    if (profile.name == name) return profile;
  const std::vector<std::string> profiles = trainingProfiles();
  const std::vector<std::string_view> known(profiles.begin(), profiles.end());
  throw InputError({{"--profile", std::nullopt, std::nullopt, "",
                     "unknown profile \"" + name + "\"" + didYouMean(name, known)}});
}

void Run::report(const TrainingProgress& progress) const {
  report(progress, progress.total > 0
                       ? static_cast<double>(progress.done) / static_cast<double>(progress.total)
                       : 1);
}

void Run::report(TrainingProgress progress, double share) const {
  if (!control.progress) return;
  whole.reach(progress.stage, share);
  progress.stage_number = stage_number;
  progress.num_stages = num_stages;
  progress.share = share;
  progress.worked = whole.worked();
  progress.left = whole.left();
  control.progress(progress);
}

void Run::warn(const std::string& text) const {
  if (control.warning) control.warning(text);
}

void Run::log(const std::string& json_line) const {
  std::ofstream(options.model / "training.jsonl", std::ios::app) << json_line << '\n';
}

std::filesystem::path Run::checkpoint(TrainingStage stage) const {
  return options.model / (std::string(name(stage)) + ".checkpoint");
}

namespace {

/// The datasets are folders in the folder of data, which is none itself.
void checkDataFolder(const std::filesystem::path& data) {
  if (std::filesystem::exists(data / "dataset.json"))
    throw InputError({{data.string(), std::nullopt, std::nullopt, "",
                       "is a dataset; expected a folder of datasets, as the one it lies in"}});
}

/// The model's manifest; files of the stage `anew` and of later ones may be lost, as they are made
/// again. A fault of a file says which stage makes it.
ModelManifest manifestOf(const std::filesystem::path& model, std::optional<TrainingStage> anew) {
  try {
    return readModelManifest(model, anew);
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults)
      for (int i = 0; i < kNumTrainingStages; ++i) {
        const auto stage = static_cast<TrainingStage>(i);
        for (const char* file : filesOf(stage))
          if (fault.path == (model / file).string())
            fault.message += "; bring it back, or train stage " + std::string(name(stage)) +
                             " again, with --anew, and those after it";
      }
    throw InputError(std::move(faults));
  }
}

/// The manifest has one profile and one seed, which says what the model never saw.
void checkOptions(const Run& run, const ModelManifest& manifest) {
  std::vector<Fault> faults;
  const auto expect = [&](const std::string& key, const std::string& expected,
                          const std::string& found) {
    if (expected != found)
      faults.push_back({(run.options.model / kModelManifestFile).string(), std::nullopt,
                        std::nullopt, key,
                        "expected " + expected + ", found " + found + "; go on with --" + key +
                            " " + found + ", or train all stages with --anew"});
  };
  expect("seed", std::to_string(run.options.seed), std::to_string(manifest.seed));
  expect("profile", run.profile.name, manifest.profile);
  if (!faults.empty()) throw InputError(std::move(faults));
}

/// Whether the model has something that training from that stage on would undo.
bool undoesSomething(const Run& run, const ModelManifest& manifest, TrainingStage first) {
  if (first == TrainingStage::kLearnConcepts &&
      std::filesystem::exists(run.options.model / kModelManifestFile))
    return true;
  for (int i = static_cast<int>(first); i < kNumTrainingStages; ++i) {
    const auto stage = static_cast<TrainingStage>(i);
    if (manifest.has(stage) || std::filesystem::exists(run.checkpoint(stage))) return true;
  }
  return false;
}

/// Finds what is wrong with a call before anything of the model is undone.
/// @param missing the stages to be made, in order
void checkInputs(const Run& run, const ModelManifest& manifest,
                 const std::vector<TrainingStage>& missing) {
  for (auto stage = missing.begin(); stage != missing.end(); ++stage) {
    checkData(run, *stage);
    if (*stage == TrainingStage::kLearnConcepts) {
      if (!run.options.start_from.empty()) {
        const auto path = run.options.start_from / kConceptsFile;
        decodeTensors(readFile(path), path);
      }
      continue;
    }
    const auto before = static_cast<TrainingStage>(static_cast<int>(*stage) - 1);
    const bool kept = manifest.has(before) && before < missing.front();
    if (!kept && std::find(missing.begin(), stage, before) == stage)
      throw InputError({{run.options.model.string(), std::nullopt, std::nullopt, "",
                         "stage " + std::string(name(*stage)) + " needs the stages before it"}});
  }
}

/// Takes a stage and those that build on it out of the model, so that what is killed before the
/// stage is made anew does not pass for finished.
void undo(const Run& run, ModelManifest& manifest, TrainingStage first) {
  for (int stage = static_cast<int>(first); stage < kNumTrainingStages; ++stage)
    std::filesystem::remove(run.checkpoint(static_cast<TrainingStage>(stage)));
  std::erase_if(manifest.stages, [&](TrainingStage done) { return done >= first; });
  if (first <= TrainingStage::kMakeSymbols) manifest.measures.clear();
  if (manifest.stages.empty())
    std::filesystem::remove(run.options.model / kModelManifestFile);
  else
    writeModelManifest(run.options.model, manifest);
}

std::vector<Work> workOf(TrainingStage stage) {
  switch (stage) {
    case TrainingStage::kLearnConcepts:
      return conceptWork();
    case TrainingStage::kMakeSymbols:
      return symbolWork();
    case TrainingStage::kCountTransitions:
      return transitionWork();
    case TrainingStage::kTrainVict:
      return victWork();
  }
  return {};
}

/// The work of stages one after another; datasets that an earlier one makes are not made again.
WholeRun wholeRun(const std::vector<TrainingStage>& stages) {
  std::vector<Work> works;
  for (const TrainingStage stage : stages)
    for (const Work& work : workOf(stage))
      if (!work.name.starts_with("data: ") ||
          std::none_of(works.begin(), works.end(),
                       [&work](const Work& earlier) { return earlier.name == work.name; }))
        works.push_back(work);
  return WholeRun(std::move(works));
}

}  // namespace

}  // namespace training

std::vector<std::string> trainingProfiles() { return {"cpu", "paper", "smoke", "smoke-paper"}; }

bool train(const std::vector<TrainingStage>& stages, const TrainingOptions& options,
           const TrainingControl& control) {
  if (options.resume && options.anew)
    throw std::invalid_argument("train: asked both to resume and to begin anew");
  training::Profile profile = training::profileNamed(options.profile);
  profile.concepts.seed = options.seed;
  profile.vict.seed = options.seed;
  training::WholeRun whole;
  training::Run run{options, control, std::move(profile), whole};
  training::checkDataFolder(options.data);
  createFolder(options.model);
  const TorchThreads threads(options.jobs);

  ModelManifest manifest;
  const std::optional<TrainingStage> remade =
      options.resume || stages.empty() ? std::nullopt : std::optional(stages.front());
  if (remade != TrainingStage::kLearnConcepts &&
      std::filesystem::exists(options.model / kModelManifestFile)) {
    manifest = training::manifestOf(options.model, remade);
    training::checkOptions(run, manifest);
  }
  if (remade && !options.anew && training::undoesSomething(run, manifest, *remade))
    throw InputError({{options.model.string(), std::nullopt, std::nullopt, "",
                       "holds stage " + std::string(name(*remade)) +
                           " or later ones, finished or begun; go on with --resume, or begin "
                           "again with --anew"}});
  std::vector<TrainingStage> missing;
  for (const TrainingStage stage : stages)
    if (options.resume && manifest.has(stage))
      std::filesystem::remove(run.checkpoint(stage));  // killed before it could remove it
    else
      missing.push_back(stage);
  training::checkInputs(run, manifest, missing);
  if (!options.resume && !missing.empty()) training::undo(run, manifest, missing.front());
  whole = training::wholeRun(missing);
  run.num_stages = static_cast<int>(stages.size());
  for (const TrainingStage stage : missing) {
    run.stage_number =
        1 + static_cast<int>(std::find(stages.begin(), stages.end(), stage) - stages.begin());
    if (stage == TrainingStage::kLearnConcepts) {
      manifest = {};
      manifest.name = std::filesystem::weakly_canonical(options.model).filename().string();
      manifest.profile = run.profile.name;
      manifest.encoder = run.profile.concepts.encoder;
      manifest.seed = options.seed;
      manifest.revision = CONCEPTPLAN_REVISION;
    }
    bool done = false;
    switch (stage) {
      case TrainingStage::kLearnConcepts:
        done = trainConcepts(run, manifest);
        break;
      case TrainingStage::kMakeSymbols:
        done = makeSymbols(run, manifest);
        break;
      case TrainingStage::kCountTransitions:
        done = countTransitions(run, manifest);
        break;
      case TrainingStage::kTrainVict:
        done = trainVict(run, manifest);
        break;
    }
    if (!done) return false;
    manifest.stages.push_back(stage);
    for (const char* data : {"concepts-train", "concepts-validation", "tasks-train"})
      if (const auto path = options.data / data / "dataset.json"; std::filesystem::exists(path))
        manifest.data[data] = hexadecimal(crc32OfFile(path));
    writeModelManifest(options.model, manifest);
    std::filesystem::remove(run.checkpoint(stage));
  }
  return true;
}

}  // namespace conceptplan
