#include <stdexcept>

#include "commands.hpp"
#include "conceptplan/pipeline/generation.hpp"
#include "exit_code.hpp"
#include "number_range.hpp"
#include "task_set_options.hpp"

namespace conceptplan::cli {
namespace {

struct GenerateTasksOptions {
  TaskDatasetOptions dataset;
  bool no_images = false;
  std::string out;
};

int makeTasks(GenerateTasksOptions options, Session& session) {
  options.dataset.seed = session.options.seed;
  if (options.no_images) options.dataset.frames = Frames::kNone;
  const GenerationControl control{session.options.jobs, session.console.progress("pictures"),
                                  &session.cancel};
  try {
    if (!generateTasks(options.out, options.dataset, control)) throw Interrupted{};
  } catch (const std::invalid_argument& error) {  // options that do not go together
    throw InputError({Fault{"generate tasks", {}, {}, "", error.what()}});
  }
  const TaskDataset dataset(options.out);
  session.console.printJson({{"folder", options.out}, {"tasks", dataset.tasks().size()}});
  session.console.print(options.out + ": " + std::to_string(dataset.tasks().size()) + " tasks");
  return kDone;
}

}  // namespace

void addGenerateTasksCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<GenerateTasksOptions>();
  CLI::App& command =
      line.add(group, "tasks", "Causal planning tasks with the pictures of every step",
               "conceptplan generate tasks --level 3 --split test --count 200 --out data/level3",
               [options](Session& session) { return makeTasks(*options, session); });
  TaskDatasetOptions& dataset = options->dataset;
  command
      .add_option("--level", dataset.levels,
                  "1 movement, 2 + obstacles, 3 + dyer, 4 + rotation; several as 1,2,3")
      ->delimiter(',')
      ->check(inRange(1, 4))
      ->type_name("1..4");
  command.add_option("--count", dataset.count, "Tasks a level; 1000 if left out")
      ->check(inRange(1, 10000000))
      ->type_name("N");
  command.add_option("--out", options->out, "Folder of the dataset; an interrupted one goes on")
      ->required()
      ->type_name("DIR");
  addSplit(command, dataset.split, "train if left out");
  addObjects(command, dataset.objects);
  addDomain(command, dataset.domain);
  addChoice(command, "--combination", dataset.combination, {"all", "unseen-task"}, combinationNamed,
            "unseen-task: training plans use other action types than test plans");
  addChoice(command, "--frames", dataset.frames, {"none", "ends", "all"}, framesNamed,
            "Which pictures: none, initial state and goal, or every step (all, if left out)");
  command.add_flag("--no-images", options->no_images, "Task descriptions alone: --frames none");
}

}  // namespace conceptplan::cli
