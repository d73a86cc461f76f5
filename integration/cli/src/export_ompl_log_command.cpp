#include "commands.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "exit_code.hpp"
#include "ompl_log.hpp"
#include "result_log.hpp"

namespace conceptplan::cli {
namespace {

struct ExportOmplLogOptions {
  std::string results;
  std::string out;
};

int exportOmplLog(const ExportOmplLogOptions& options, Session& session) {
  const std::vector<Json> results = readResults(options.results);
  if (results.empty()) {
    throw InputError({Fault{options.results, {}, {}, "", "holds no result of solve"}});
  }
  OmplLogHeading heading;
  heading.experiment = std::filesystem::path(options.results).stem().string();
  heading.start = std::chrono::time_point_cast<std::chrono::system_clock::duration>(
      std::chrono::file_clock::to_sys(std::filesystem::last_write_time(options.results)));
  heading.seed = results.front()["seed"].get<std::uint64_t>();
  writeFileAtomically(options.out, toOmplLog(results, heading));
  session.console.print(options.out + ": " + std::to_string(results.size()) + " runs");
  session.console.printJson({{"log", options.out}, {"runs", results.size()}});
  return kDone;
}

}  // namespace

void addExportOmplLogCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<ExportOmplLogOptions>();
  CLI::App& command =
      line.add(group, "ompl-log", "Results of solve as a benchmark log of OMPL",
               "conceptplan export ompl-log out/results.jsonl --out out/results.log",
               [options](Session& session) { return exportOmplLog(*options, session); });
  command.add_option("RESULTS", options->results, "File that solve wrote, a line each")->required();
  command.add_option("--out", options->out, "The log")->required()->type_name("FILE");
}

}  // namespace conceptplan::cli
