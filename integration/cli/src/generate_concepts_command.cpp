#include "commands.hpp"
#include "conceptplan/pipeline/generation.hpp"
#include "exit_code.hpp"
#include "number_range.hpp"
#include "task_set_options.hpp"

namespace conceptplan::cli {
namespace {

struct GenerateConceptsOptions {
  ConceptDatasetOptions dataset;
  std::string out;
};

int makeConcepts(GenerateConceptsOptions options, Session& session) {
  options.dataset.seed = session.options.seed;
  const GenerationControl control{session.options.jobs, session.console.progress("crops"),
                                  &session.cancel};
  if (!generateConcepts(options.out, options.dataset, control)) throw Interrupted{};
  const std::size_t size = ConceptDataset(options.out).size();
  session.console.printJson({{"folder", options.out}, {"images", size}});
  session.console.print(options.out + ": " + std::to_string(size) + " pictures");
  return kDone;
}

}  // namespace

void addGenerateConceptsCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<GenerateConceptsOptions>();
  CLI::App& command =
      line.add(group, "concepts", "Pictures of single objects in every combination of concepts",
               "conceptplan generate concepts --split train --out data/concepts",
               [options](Session& session) { return makeConcepts(*options, session); });
  command.add_option("--out", options->out, "Folder of the dataset; an interrupted one goes on")
      ->required()
      ->type_name("DIR");
  command
      .add_option("--samples", options->dataset.samples,
                  "Colour samples of each combination; 20 if left out")
      ->check(inRange(1, kNumColorSamples))
      ->type_name("N");
  addSplit(command, options->dataset.split,
           "train (40 % of the combinations, if left out), validation (10 %) or test (50 %)");
  addDomain(command, options->dataset.domain);
}

}  // namespace conceptplan::cli
