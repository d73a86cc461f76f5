#include "commands.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/planners/pddl/pddl_export.hpp"
#include "determinisation_options.hpp"
#include "exit_code.hpp"
#include "scenario_check.hpp"
#include "scenario_solver.hpp"

namespace conceptplan::cli {
namespace {

struct ExportPddlOptions {
  std::string path;
  std::string model;
  std::string out;
  DeterminisationOptions determinisation;
};

using PddlWriter = PddlText (*)(const SymbolGraph&, const PddlOptions&);

int exportPddl(const ExportPddlOptions& options, const std::string& ending, PddlWriter write,
               Session& session) {
  ScenarioSolver solver;
  const CompiledScenario compiled = solver.compile(findScenario(options.path), options.model);
  PddlOptions pddl;
  pddl.name = compiled.scenario.name;
  pddl.determinisation = determinisationOf(compiled.scenario, options.determinisation);
  pddl.symbol_names = compiled.model->symbolic().grounding.names;
  const PddlText text = write(compiled.graph, pddl);
  const std::filesystem::path folder = options.out;
  createFolder(folder);
  const std::filesystem::path domain = folder / ("domain." + ending);
  const std::filesystem::path problem = folder / ("problem." + ending);
  writeFileAtomically(domain, text.domain);
  writeFileAtomically(problem, text.problem);
  session.console.print(domain.string() + "\n" + problem.string());
  session.console.printJson({{"domain", domain.string()}, {"problem", problem.string()}});
  return kDone;
}

void addOne(CommandLine& line, CLI::App& group, const std::string& format,
            const std::string& summary, PddlWriter write) {
  const auto options = makeOptions<ExportPddlOptions>();
  CLI::App& command =
      line.add(group, format, summary,
               "conceptplan export " + format + " scenarios/level3-0001 --out out/level3-0001",
               [options, format, write](Session& session) {
                 return exportPddl(*options, format, write, session);
               });
  command.add_option("SCENARIO", options->path, "Scenario file or folder")->required();
  command
      .add_option("--out", options->out, "Folder for domain." + format + " and problem." + format)
      ->required()
      ->type_name("DIR");
  command.add_option("--model", options->model, "A model in place of the scenario's own")
      ->type_name("NAME|DIR");
  addDeterminisation(command, options->determinisation);
}

}  // namespace

void addExportPddlCommands(CommandLine& line, CLI::App& group) {
  addOne(line, group, "pddl", "A scenario in PDDL: most probable outcomes, with action costs",
         toPddl);
  addOne(line, group, "ppddl", "A scenario in PPDDL: all outcomes, with their probabilities",
         toPpddl);
}

void addExportCommands(CommandLine& line) {
  CLI::App& group = line.addGroup("export", "A scenario, its plans, or results in others' formats");
  addExportPddlCommands(line, group);
  addExportPlanCommand(line, group);
  addExportOmplLogCommand(line, group);
}

}  // namespace conceptplan::cli
