#include "commands.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "exit_code.hpp"
#include "number_range.hpp"
#include "scenario_generation.hpp"
#include "task_set_options.hpp"

namespace conceptplan::cli {
namespace {

struct GenerateScenariosOptions {
  ScenarioSetOptions set;
  std::string out;
};

int makeScenarios(GenerateScenariosOptions options, Session& session) {
  options.set.tasks.seed = session.options.seed;
  if (options.set.targets > 1 && (options.set.tasks.level == 1 || options.set.infeasible)) {
    throw InputError({Fault{"--targets", {}, {}, "", "2 need --level 2..4, and no --infeasible"}});
  }
  if (options.set.symbols_only) {
    const std::filesystem::path model = findModel(options.set.model);
    options.set.grounding = readSymbolicModel(model / kTransitionsFile).grounding;
  }
  const std::vector<std::filesystem::path> folders =
      generateScenarios(options.out, options.set, session.options.jobs,
                        session.console.progress("scenarios"), session.cancel);
  Json list = Json::array();
  for (const std::filesystem::path& folder : folders) {
    list.push_back(folder.string());
    session.console.print(folder.string());
  }
  if (folders.size() < static_cast<std::size_t>(options.set.count)) throw Interrupted{};
  session.console.printJson({{"scenarios", list}});
  return kDone;
}

}  // namespace

void addGenerateScenariosCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<GenerateScenariosOptions>();
  CLI::App& command =
      line.add(group, "scenarios", "Stand-alone scenario folders with their ground truth",
               "conceptplan generate scenarios --level 3 --count 3 --out scenarios",
               [options](Session& session) { return makeScenarios(*options, session); });
  TaskOptions& tasks = options->set.tasks;
  tasks.split = Split::kTest;
  command.add_option("--level", tasks.level, "1 movement, 2 + obstacles, 3 + dyer, 4 + rotation")
      ->check(inRange(1, 4))
      ->type_name("1..4");
  command.add_option("--count", options->set.count, "Number of scenarios; 1 if left out")
      ->check(inRange(1, 100000))
      ->type_name("N");
  command.add_option("--out", options->out, "Folder in which the scenarios' folders are made")
      ->required()
      ->type_name("DIR");
  addSplit(command, tasks.split, "Which tasks; test if left out");
  addObjects(command, tasks.objects);
  addDomain(command, options->set.domain);
  command.add_option("--model", options->set.model, "The model that the scenarios name")
      ->type_name("NAME|DIR");
  command.add_flag("--symbols-only", options->set.symbols_only,
                   "No pictures: the true values as symbols of the model, by their names");
  command
      .add_option("--targets", options->set.targets,
                  "Objects to be moved, 1 if left out; 2 from level 2 on, of which one is an "
                  "obstacle otherwise")
      ->check(inRange(1, 2))
      ->type_name("1..2");
  command.add_flag("--infeasible", options->set.infeasible,
                   "Scenarios without a solution: the target is shut in");
}

void addGenerateCommands(CommandLine& line) {
  CLI::App& group = line.addGroup("generate", "Make concept sets, tasks, scenarios and pictures");
  addGenerateConceptsCommand(line, group);
  addGenerateTasksCommand(line, group);
  addGenerateScenariosCommand(line, group);
  addGenerateImagesCommand(line, group);
}

}  // namespace conceptplan::cli
