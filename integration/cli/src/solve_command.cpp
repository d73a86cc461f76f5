#include <algorithm>
#include <chrono>

#include "choice_option.hpp"
#include "commands.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "conceptplan/pipeline/parallel_work.hpp"
#include "exit_code.hpp"
#include "ompl_log.hpp"
#include "result_json.hpp"
#include "scenario_solver.hpp"
#include "search_options.hpp"

namespace conceptplan::cli {
namespace {

enum class Format { kJsonLines, kCsv, kOmplLog };

std::optional<Format> formatNamed(std::string_view name) {
  if (name == "jsonl") return Format::kJsonLines;
  if (name == "csv") return Format::kCsv;
  if (name == "ompl-log") return Format::kOmplLog;
  return std::nullopt;
}

struct SolveCommandOptions {
  std::vector<std::string> paths;
  std::vector<std::string> planners;
  std::string model;
  std::string out;
  Format format = Format::kJsonLines;
  bool resume = false;
  SearchLimits limits;
};

/// One scenario for one planner.
struct Job {
  std::filesystem::path file;
  std::string planner;  ///< empty: the scenario's own
  ResultKey key;
};

std::vector<Job> jobsOf(const SolveCommandOptions& options, const PlannerRegistry& registry,
                        std::uint64_t seed) {
  std::vector<Fault> faults;
  const auto collect = [&faults](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  };
  for (const std::string& planner : options.planners) {
    collect([&] { registry.make(planner, {}, "--planners"); });
  }
  std::vector<std::filesystem::path> files;
  for (const std::string& path : options.paths) {
    collect([&] {
      for (const std::filesystem::path& file : findScenarios(path)) {
        if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
      }
    });
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  std::vector<Job> jobs;
  for (const std::filesystem::path& file : files) {
    if (options.planners.empty()) jobs.push_back({file, "", {resultName(file), "", seed}});
    for (auto planner = options.planners.begin(); planner != options.planners.end(); ++planner) {
      const bool repeated = std::find(options.planners.begin(), planner, *planner) != planner;
      if (!repeated) jobs.push_back({file, *planner, {resultName(file), *planner, seed}});
    }
  }
  return jobs;
}

/// The scenario's own planner, where it can be read.
std::string ownPlanner(const std::filesystem::path& file) {
  try {
    return readScenario(file).planner.name;
  } catch (const InputError&) {
    return "";
  }
}

Json solveOne(ScenarioSolver& solver, const Job& job, const SolveCommandOptions& options,
              const std::atomic<bool>& cancel) {
  SolveOptions solve;
  solve.seed = job.key.seed;
  solve.render = false;
  solve.limits = options.limits;
  solve.limits.cancel = &cancel;
  try {
    return resultJson(job.key, solver.solve(job.file, job.planner, options.model, solve).solution);
  } catch (const InputError& error) {
    return invalidInputJson(job.key, error);
  } catch (const std::exception& error) {
    return failedJson(job.key, error.what());
  }
}

void report(const Json& result, Console& console) {
  if (result["status"] == "invalid_input" || result["status"] == "failed") {
    console.error("conceptplan: " + result["reason"].get<std::string>());
  }
}

int solveAll(const SolveCommandOptions& options, Session& session) {
  const bool appends = options.format == Format::kJsonLines;
  if (options.resume && !appends) {
    throw InputError({Fault{"--resume", {}, {}, "", "only a jsonl file can be resumed"}});
  }
  if (options.out.empty() && (options.resume || !appends)) {
    throw InputError({Fault{"--out", {}, {}, "", "--resume and --format need a file"}});
  }
  const auto start = std::chrono::system_clock::now();
  ScenarioSolver solver;
  std::vector<Job> jobs = jobsOf(options, solver.registry(), session.options.seed);
  std::vector<ResultKey> keys;
  for (Job& job : jobs) {
    if (job.planner.empty()) job.key.planner = ownPlanner(job.file);
    keys.push_back(job.key);
  }
  ResultLog log(appends ? options.out : "", keys, options.resume);
  const Progress progress = session.console.progress("scenarios");
  progress(log.numResults(), jobs.size());
  workInParallel(jobs.size(), session.options.jobs, &session.cancel, [&]() -> Worker {
    return [&](std::size_t number) {
      const Job& job = jobs[number];
      if (log.has(job.key)) return;
      const Json result = solveOne(solver, job, options, session.cancel);
      if (session.cancel) return;  // a search that was cut short is not finished
      log.add(result);
      report(result, session.console);
      progress(log.numResults(), jobs.size());
    };
  });
  std::vector<Json> results = log.results();
  if (options.format == Format::kCsv) writeFileAtomically(options.out, toCsv(results));
  if (options.format == Format::kOmplLog) {
    OmplLogHeading heading = headingHere(std::filesystem::path(options.out).stem().string());
    heading.duration_s = std::chrono::duration<double>(heading.start - start).count();
    heading.start = start;
    heading.seed = session.options.seed;
    heading.timeout_s = options.limits.timeout_s;
    writeFileAtomically(options.out, toOmplLog(results, heading));
  }
  if (log.numResults() < jobs.size()) throw Interrupted{};
  log.finish();
  session.console.print(toTable(results));
  for (Json& result : results) result.erase("trace");  // for files
  session.console.printJson({{"results", results}});
  return exitCodeOf(results);
}

}  // namespace

void addSolveCommand(CommandLine& line) {
  const auto options = makeOptions<SolveCommandOptions>();
  CLI::App& command =
      line.add("solve", "Solve any number of scenarios with any number of planners",
               "conceptplan solve scenarios --planners belief,bfs --out results.jsonl --resume",
               [options](Session& session) { return solveAll(*options, session); });
  command.add_option("PATH", options->paths, "Scenario files, folders, or folders of folders")
      ->required();
  command
      .add_option("--planners", options->planners,
                  "Planners by name, a,b,c; each scenario's own if left out")
      ->delimiter(',')
      ->type_name("NAMES");
  command.add_option("--model", options->model, "A model in place of the scenarios' own")
      ->type_name("NAME|DIR");
  command.add_option("--out", options->out, "File of the results, a line each")->type_name("FILE");
  addChoice(command, "--format", options->format, {"jsonl", "csv", "ompl-log"}, formatNamed,
            "Of the file; jsonl if left out");
  command.add_flag("--resume", options->resume, "Keep the results that the file has already");
  addLimits(command, options->limits);
}

}  // namespace conceptplan::cli
