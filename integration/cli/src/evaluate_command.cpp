#include "commands.hpp"
#include "conceptplan/pipeline/all_planners.hpp"
#include "conceptplan/pipeline/evaluation.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

struct EvaluateCommandOptions {
  std::string tasks;
  std::string model = "default";
  std::vector<std::string> planners{"belief"};
};

Json rowJson(const EvaluationRow& row) {
  Json failures = Json::object();
  for (const auto& [cause, count] : row.failures) failures[cause] = count;
  return {{"learner", row.learner},       {"planner", row.planner}, {"set", row.set},
          {"level", row.level},           {"tasks", row.tasks},     {"asacc_top1", row.asacc_top1},
          {"asacc_top5", row.asacc_top5}, {"ase", row.ase},         {"fsd", row.fsd},
          {"failures", failures}};
}

std::vector<std::string> rowText(const EvaluationRow& row) {
  std::string failures;
  for (const auto& [cause, count] : row.failures) {
    failures += (failures.empty() ? "" : ", ") + cause + " " + std::to_string(count);
  }
  return {row.planner,
          row.set,
          std::to_string(row.level),
          std::to_string(row.tasks),
          decimal(row.asacc_top1, 1),
          decimal(row.asacc_top5, 1),
          decimal(row.ase, 3),
          decimal(row.fsd, 3),
          failures.empty() ? "-" : failures};
}

int evaluateTasks(const EvaluateCommandOptions& options, Session& session) {
  const PlannerRegistry registry = allPlanners();
  for (const std::string& planner : options.planners) registry.make(planner, {}, "--planners");
  const TaskDataset tasks(options.tasks);
  const Model model(findModel(options.model));
  EvaluationOptions evaluation;
  evaluation.planners = options.planners;
  evaluation.jobs = session.options.jobs;
  evaluation.seed = session.options.seed;
  evaluation.progress = session.console.progress("tasks");
  evaluation.cancel = &session.cancel;
  const std::vector<EvaluationRow> rows = evaluate(tasks, model, registry, evaluation);
  if (session.cancel) throw Interrupted{};
  Json list = Json::array();
  TextTable table{{"planner", "set", "level", "tasks", "ASAcc top-1 %", "ASAcc top-5 %", "ASE",
                   "FSD", "failures"}};
  for (const EvaluationRow& row : rows) {
    list.push_back(rowJson(row));
    table.push_back(rowText(row));
  }
  session.console.print(table);
  session.console.printJson({{"rows", list}});
  return kDone;
}

}  // namespace

void addEvaluateCommand(CommandLine& line) {
  const auto options = makeOptions<EvaluateCommandOptions>();
  CLI::App& command =
      line.add("evaluate", "Accuracy and efficiency of planners on a set of tasks",
               "conceptplan evaluate --tasks data/test-level3 --planners belief,bfs",
               [options](Session& session) { return evaluateTasks(*options, session); });
  command.add_option("--tasks", options->tasks, "Set of tasks with the pictures of start and goal")
      ->required()
      ->type_name("DIR");
  command
      .add_option("--planners", options->planners, "Planners by name, a,b,c; belief if left out")
      ->delimiter(',')
      ->type_name("NAMES");
  command.add_option("--model", options->model, "A shipped model's name, or a folder")
      ->type_name("NAME|DIR");
}

}  // namespace conceptplan::cli
