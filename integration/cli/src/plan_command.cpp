#include "commands.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/nlopt/trajectory_file.hpp"
#include "conceptplan/pipeline/report.hpp"
#include "exit_code.hpp"
#include "result_json.hpp"
#include "scenario_check.hpp"
#include "scenario_solver.hpp"
#include "search_options.hpp"
#include "stale_files.hpp"

namespace conceptplan::cli {
namespace {

struct PlanCommandOptions {
  std::string path;
  std::string planner;
  std::string model;
  std::string out;
  bool no_render = false;
  SearchLimits limits;
};

std::string stepName(std::size_t step) {
  return std::string("step-") + (step < 10 ? "0" : "") + std::to_string(step) + ".png";
}

/// result.json, which comes last, report.html, the predicted frames and the refined motion, in
/// place of an earlier run's.
void writeFolder(const std::filesystem::path& folder, const SolvedScenario& solved,
                 const Json& result, std::uint64_t seed) {
  createFolder(folder);
  for (const char* file : {"result.json", "report.html", "trajectory.json", "trajectory.csv"}) {
    removeStale(folder / file);
  }
  removeStale(folder, stepName);
  for (std::size_t i = 0; i < solved.solution.frames.size(); ++i) {
    const RgbdImage& frame = solved.solution.frames[i];
    writeFileAtomically(folder / stepName(i + 1), encodePng(frame.width, frame.height, frame.rgb));
  }
  if (solved.solution.refinement) writeTrajectory(folder, *solved.solution.refinement);
  writeReport(folder / "report.html",
              reportOf(solved.scenario, *solved.model, solved.solution, solved.planner, seed));
  writeFileAtomically(folder / "result.json", result.dump(2) + "\n");
}

TextTable plansTable(const Json& plans) {
  TextTable table{{"plan", "probability", "length", "actions"}};
  for (const Json& plan : plans) {
    const std::string actions = actionsText(plan);
    table.push_back({std::to_string(table.size()), decimal(plan["probability"], 4),
                     plan["length"].dump(), actions.empty() ? "nothing to do" : actions});
  }
  return table;
}

void printSolution(const SolvedScenario& solved, const Json& json, Console& console) {
  const PlanResult& result = solved.solution.result;
  console.print(solved.scenario.name + ": " + std::string(name(result.status)) +
                (result.reason.empty() ? "" : ", " + result.reason));
  if (!result.plans.empty()) console.print(plansTable(json["plans"]));
  for (const std::string& doubt : solved.solution.doubts) console.print(doubt);
  if (const auto& evaluation = solved.solution.evaluation) {
    const auto& failure = evaluation->best.failure;
    console.print("in the simulator the best plan " +
                  (failure ? "fails: " + std::string(name(*failure)) : "reaches the goal"));
  }
  if (const auto& refinement = solved.solution.refinement) {
    console.print("motion: " + decimal(1000 * refinement->length_m, 0) + " mm, " +
                  decimal(1000 * refinement->clearance_m, 1) + " mm clear" +
                  (refinement->fell_back ? "; the plan as it is, since " + refinement->reason
                                         : std::string()));
  }
}

int plan(const PlanCommandOptions& options, Session& session) {
  const std::filesystem::path file = findScenario(options.path);
  SolveOptions solve;
  solve.seed = session.options.seed;
  solve.render = !options.no_render && !options.out.empty();
  solve.limits = options.limits;
  solve.limits.cancel = &session.cancel;
  ScenarioSolver solver;
  const SolvedScenario solved = solver.solve(file, options.planner, options.model, solve);
  if (session.cancel) throw Interrupted{};
  const std::string scenario = file.parent_path().lexically_normal().string();
  const Json result = resultJson({scenario, solved.planner, session.options.seed}, solved.solution);
  printSolution(solved, result, session.console);
  if (!options.out.empty()) {
    writeFolder(options.out, solved, result, session.options.seed);
    session.console.print("report: " + options.out + "/report.html");
  }
  session.console.printJson(result);
  return exitCodeOf({result});
}

}  // namespace

void addPlanCommand(CommandLine& line) {
  const auto options = makeOptions<PlanCommandOptions>();
  CLI::App& command = line.add("plan", "Plan one scenario: plans, predicted frames and a report",
                               "conceptplan plan scenarios/level3-0001 --out out/level3-0001",
                               [options](Session& session) { return plan(*options, session); });
  command.add_option("SCENARIO", options->path, "Scenario file or folder")->required();
  command
      .add_option("--out", options->out,
                  "Folder for result.json, report.html, step-NN.png, the predicted frames, and "
                  "trajectory.json and trajectory.csv, the refined motion")
      ->type_name("DIR");
  command.add_option("--planner", options->planner, "A planner in place of the scenario's own")
      ->type_name("NAME");
  command.add_option("--model", options->model, "A model in place of the scenario's own")
      ->type_name("NAME|DIR");
  command.add_flag("--no-render", options->no_render, "Predict no frames");
  addLimits(command, options->limits);
}

}  // namespace conceptplan::cli
