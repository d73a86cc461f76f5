#include <chrono>
#include <optional>

#include "choice_option.hpp"
#include "commands.hpp"
#include "conceptplan/pipeline/training.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

const std::vector<TrainingStage> kAllStages{
    TrainingStage::kLearnConcepts, TrainingStage::kMakeSymbols, TrainingStage::kCountTransitions,
    TrainingStage::kTrainVict};

struct TrainCommandOptions {
  std::vector<TrainingStage> stages;
  TrainingOptions training;
};

std::optional<std::vector<TrainingStage>> stagesNamed(std::string_view text) {
  if (text == "all") return kAllStages;
  for (const TrainingStage stage : kAllStages) {
    if (name(stage) == text) return std::vector{stage};
  }
  return std::nullopt;
}

Json allMeasures(const ModelManifest& manifest) {
  Json measures = Json::object();
  for (const auto& [name, value] : manifest.measures) measures[name] = value;
  return measures;
}

std::string labelOf(const TrainingProgress& state) {
  if (state.num_stages == 1) return state.stage;
  return "stage " + std::to_string(state.stage_number) + " of " + std::to_string(state.num_stages) +
         ": " + state.stage;
}

/// Tells the time left of all stages by the pace of the work that is under way, so that it never
/// contradicts that work's own bar.
class TimeLeft {
 public:
  void begin(const TrainingProgress& state) {
    start_ = Clock::now();
    worked_before_ = state.worked;
  }

  /// Empty as long as nothing tells.
  std::string inAll(const TrainingProgress& state) {
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    const double worked = state.worked - worked_before_;
    if (worked > 0) pace_s_ = elapsed.count() / worked;
    return pace_s_ ? durationText(*pace_s_ * state.left) + " left in all" : "";
  }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_;
  double worked_before_ = 0;
  std::optional<double> pace_s_;  // of a percent of the whole
};

int trainStages(TrainCommandOptions options, Session& session) {
  options.training.seed = session.options.seed;
  options.training.jobs = session.options.jobs;
  std::string label;
  std::optional<Progress> progress;
  TimeLeft time_left;
  TrainingControl control;
  control.cancel = &session.cancel;
  control.progress = [&](const TrainingProgress& state) {
    const std::string now = labelOf(state);
    if (!progress || label != now) {
      label = now;
      progress = session.console.progress(label);
      time_left.begin(state);
    }
    std::string note = time_left.inAll(state);
    if (!state.message.empty()) note += (note.empty() ? "" : "  ") + state.message;
    (*progress)(state.done, state.total, note, state.share);
  };
  control.warning = [&session](const std::string& text) {
    session.console.message("warning: " + text);
  };
  if (!train(options.stages, options.training, control)) throw Interrupted{};
  const ModelManifest manifest = readModelManifest(options.training.model);
  session.console.printJson(
      {{"model", options.training.model.string()}, {"measures", allMeasures(manifest)}});
  session.console.print(options.training.model.string() + ": trained");
  TextTable table;
  for (const auto& [name, value] : manifest.measures) {
    table.push_back({"  " + name, decimal(value, 4)});
  }
  session.console.print(table);
  return kDone;
}

}  // namespace

void addTrainCommand(CommandLine& line) {
  const auto options = makeOptions<TrainCommandOptions>();
  CLI::App& command =
      line.add("train", "Learn a model from rendered pictures",
               "conceptplan train all --data data --model models/mine --resume",
               [options](Session& session) { return trainStages(*options, session); });
  TrainingOptions& training = options->training;
  addChoice(command, "STAGE", options->stages,
            {"concepts", "symbols", "transitions", "vict", "all"}, stagesNamed,
            "What to train; each stage needs those before it")
      ->required();
  command
      .add_option("--data", training.data, "Folder of the datasets; missing ones are made there")
      ->required()
      ->type_name("DIR");
  command.add_option("--model", training.model, "Folder of the model")
      ->required()
      ->type_name("DIR");
  command
      .add_option("--start-from", training.start_from,
                  "Model whose concept network is trained on; a new one if left out")
      ->type_name("DIR");
  std::string profiles;
  for (const std::string& profile : trainingProfiles()) {
    profiles += (profiles.empty() ? "" : "|") + profile;
  }
  command.add_option("--profile", training.profile, "How much is learned from; cpu if left out")
      ->type_name(profiles);
  CLI::Option* resume = command.add_flag("--resume", training.resume,
                                         "Keep finished stages and go on from the last checkpoint");
  command
      .add_flag("--anew", training.anew,
                "Begin again, and undo what is finished or begun of these stages and later ones")
      ->excludes(resume);
}

}  // namespace conceptplan::cli
