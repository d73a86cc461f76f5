#include "commands.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/pipeline/all_planners.hpp"
#include "conceptplan/pipeline/frame_evaluation.hpp"
#include "evaluate_concepts.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

struct EvaluateCommandOptions {
  std::string tasks;
  std::string concepts;
  std::string model = "default";
  std::vector<std::string> planners{"belief"};
  bool frames = false;
};

Json objectsJson(const ToldObjects& count) {
  return {{"objects", count.objects}, {"told", count.told}};
}

/// Percent of the objects, or a dash.
std::string percentTold(const ToldObjects& count) {
  if (count.objects == 0) return "-";
  return decimal(100.0 * static_cast<double>(count.told) / static_cast<double>(count.objects), 1);
}

Json rowJson(const EvaluationRow& row) {
  Json failures = Json::object();
  for (const auto& [cause, count] : row.failures) failures[cause] = count;
  return {{"learner", row.learner},
          {"planner", row.planner},
          {"set", row.set},
          {"level", row.level},
          {"tasks", row.tasks},
          {"asacc_top1", row.asacc_top1},
          {"asacc_top5", row.asacc_top5},
          {"ase", row.ase},
          {"fsd", row.fsd},
          {"failures", failures},
          {"fit_no_symbol",
           {{"seen_types", objectsJson(row.seen_types)},
            {"unseen_types", objectsJson(row.unseen_types)}}}};
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
          percentTold(row.seen_types),
          percentTold(row.unseen_types),
          failures.empty() ? "-" : failures};
}

Json rowJson(const FrameEvaluationRow& row) {
  return {{"set", row.set},
          {"level", row.level},
          {"steps", row.steps},
          {"psnr_db", row.psnr_db},
          {"ssim", row.ssim},
          {"planned_steps", row.planned_steps},
          {"read_back", row.read_back},
          {"unplanned", row.unplanned}};
}

std::vector<std::string> rowText(const FrameEvaluationRow& row) {
  return {row.set,
          std::to_string(row.level),
          std::to_string(row.steps),
          decimal(row.psnr_db, 1),
          decimal(row.ssim, 3),
          std::to_string(row.planned_steps),
          decimal(row.read_back, 1),
          std::to_string(row.unplanned)};
}

int evaluateTasks(const EvaluateCommandOptions& options, Session& session) {
  if (options.tasks.empty()) {
    throw InputError({Fault{"--tasks", {}, {}, "", "a set of tasks is needed, or --concepts"}});
  }
  const PlannerRegistry registry = allPlanners();
  for (const std::string& planner : options.planners) registry.make(planner, {}, "--planners");
  const TaskDataset tasks(options.tasks);
  if (options.frames) requireAllFrames(tasks);
  if (tasks.options().split == Split::kTrain)
    session.console.message("note: models may have learned from these tasks, of the train split");
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
                   "FSD", "told unfit %: seen", "unseen types", "failures"}};
  for (const EvaluationRow& row : rows) {
    list.push_back(rowJson(row));
    table.push_back(rowText(row));
  }
  Json answer{{"rows", list}};
  session.console.print(table);
  if (options.frames) {
    evaluation.progress = session.console.progress("frames");
    const std::vector<FrameEvaluationRow> frames = evaluateFrames(tasks, model, evaluation);
    if (session.cancel) throw Interrupted{};
    TextTable frames_table{{"set", "level", "steps", "PSNR dB", "SSIM", "planned steps",
                            "read back %", "without a plan"}};
    answer["frames"] = Json::array();
    for (const FrameEvaluationRow& row : frames) {
      answer["frames"].push_back(rowJson(row));
      frames_table.push_back(rowText(row));
    }
    session.console.print(frames_table);
  }
  session.console.printJson(answer);
  return kDone;
}

}  // namespace

void addEvaluateCommand(CommandLine& line) {
  const auto options = makeOptions<EvaluateCommandOptions>();
  CLI::App& command =
      line.add("evaluate",
               "Accuracy and efficiency of planners on a set of tasks, or of symbols on a set of "
               "pictures",
               "conceptplan evaluate --tasks data/test-level3 --planners belief,bfs",
               [options](Session& session) {
                 return options->concepts.empty()
                            ? evaluateTasks(*options, session)
                            : evaluateConceptSet(options->concepts, options->model, session);
               });
  CLI::Option* tasks =
      command
          .add_option("--tasks", options->tasks, "Set of tasks with the pictures of start and goal")
          ->type_name("DIR");
  command
      .add_option("--concepts", options->concepts,
                  "In its place, a set of pictures of single objects: accuracy and calibration of "
                  "the symbols, and disentanglement of the tokens")
      ->type_name("DIR")
      ->excludes(tasks);
  command
      .add_option("--planners", options->planners, "Planners by name, a,b,c; belief if left out")
      ->delimiter(',')
      ->type_name("NAMES");
  command.add_flag("--frames", options->frames,
                   "Also draw every step: likeness to the true picture, and whether it reads as "
                   "planned");
  command.add_option("--model", options->model, "A shipped model's name, or a folder")
      ->type_name("NAME|DIR");
}

}  // namespace conceptplan::cli
