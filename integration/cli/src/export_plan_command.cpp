#include "commands.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/planners/pddl/plan_replay.hpp"
#include "determinisation_options.hpp"
#include "exit_code.hpp"
#include "scenario_check.hpp"
#include "scenario_solver.hpp"
#include "search_options.hpp"
#include "stale_files.hpp"

namespace conceptplan::cli {
namespace {

struct ExportPlanOptions {
  std::string path;
  std::string planner;
  std::string model;
  std::string out;
  DeterminisationOptions determinisation;
  SearchLimits limits;
};

std::string planName(std::size_t number) { return "plan." + std::to_string(number); }

/// The planner of that name, with the options of the scenario if that names the same one. The
/// threshold and the discount are in any case those of the problem that the plan files are about.
std::unique_ptr<Planner> plannerFor(const Determinisation& problem, const Scenario& scenario,
                                    const std::string& name, const PlannerRegistry& registry) {
  const OptionTexts shared{{"legality_threshold", Json(problem.legality_threshold).dump()},
                           {"step_discount", Json(problem.step_discount).dump()}};
  OptionTexts texts = name == scenario.planner.name ? scenario.planner.options : OptionTexts{};
  if (const PlannerEntry* entry = registry.find(name)) {
    for (const PlannerOption& option : entry->options) {
      const auto found = shared.find(option.name);
      if (found != shared.end()) texts[option.name] = found->second;
    }
  }
  return registry.make(name, texts, "--planner");
}

/// Writes the plans that are plans of the exported PDDL, in place of an earlier run's; tells of the
/// others.
Json writePlans(const std::vector<Plan>& plans, const SymbolGraph& graph,
                const Determinisation& determinisation, const std::filesystem::path& folder,
                Console& console) {
  createFolder(folder);
  removeStale(folder, planName);
  Json written = Json::array();
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    const std::filesystem::path file = folder / planName(i + 1);
    try {
      const PlanFile plan = groundPlan(graph, plans[i].actions, determinisation);
      writeFileAtomically(file, planFileText(plan));
      written.push_back({{"file", file.string()}, {"cost", *plan.cost}});
      console.print(file.string() + ": " + std::to_string(plan.steps.size()) + " actions, cost " +
                    std::to_string(*plan.cost));
    } catch (const std::invalid_argument& error) {
      console.message("plan " + number + " is none where every action has its most probable " +
                      "outcome, and is not written: " + error.what());
    }
  }
  return written;
}

int exportPlan(const ExportPlanOptions& options, Session& session) {
  ScenarioSolver solver;
  const CompiledScenario compiled = solver.compile(findScenario(options.path), options.model);
  const Scenario& scenario = compiled.scenario;
  const std::string planner = options.planner.empty() ? scenario.planner.name : options.planner;
  PlanQuery query;
  query.top = static_cast<std::size_t>(scenario.planner.top);
  query.seed = session.options.seed;
  query.limits = options.limits;
  query.limits.cancel = &session.cancel;
  const Determinisation problem = determinisationOf(scenario, options.determinisation);
  const PlanResult result =
      plannerFor(problem, scenario, planner, solver.registry())->solve(compiled.graph, query);
  if (session.cancel) throw Interrupted{};
  if (!result.reason.empty()) {
    session.console.print(std::string(name(result.status)) + ", " + result.reason);
  }
  const Json written =
      writePlans(result.plans, compiled.graph, problem, options.out, session.console);
  session.console.printJson({{"planner", planner},
                             {"status", name(result.status)},
                             {"reason", result.reason},
                             {"plans", written}});
  return written.empty() ? kNoPlan : kDone;
}

}  // namespace

void addExportPlanCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<ExportPlanOptions>();
  CLI::App& command = line.add(
      group, "plan", "The plans of a scenario as files of the International Planning Competition",
      "conceptplan export plan scenarios/level3-0001 --planner astar --out out/level3-0001",
      [options](Session& session) { return exportPlan(*options, session); });
  command.add_option("SCENARIO", options->path, "Scenario file or folder")->required();
  command.add_option("--out", options->out, "Folder for plan.1, plan.2, ..., best first")
      ->required()
      ->type_name("DIR");
  command.add_option("--planner", options->planner, "A planner in place of the scenario's own")
      ->type_name("NAME");
  command.add_option("--model", options->model, "A model in place of the scenario's own")
      ->type_name("NAME|DIR");
  addDeterminisation(command, options->determinisation);
  addLimits(command, options->limits);
}

}  // namespace conceptplan::cli
