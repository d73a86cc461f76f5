#include "commands.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/pipeline/figures.hpp"
#include "exit_code.hpp"
#include "number_range.hpp"

namespace conceptplan::cli {
namespace {

struct InspectFiguresOptions {
  std::string model;
  std::string data;
  std::string out;
  std::size_t pictures = FigureOptions{}.pictures;
};

int writeFigures(const InspectFiguresOptions& options, Session& session) {
  const ConceptDataset data(options.data);
  const Model model(findModel(options.model));
  createFolder(options.out);
  const std::vector<Figure> drawn = drawFigures(
      model, data, {options.pictures, session.options.seed, session.console.progress("pictures")});
  Json files = Json::array();
  for (const Figure& figure : drawn) {
    const auto file = std::filesystem::path(options.out) / (figure.name + ".svg");
    writeFileAtomically(file, figure.svg);
    files.push_back(file.string());
    session.console.print(file.string());
  }
  session.console.printJson({{"images", files}});
  return kDone;
}

}  // namespace

void addInspectFiguresCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<InspectFiguresOptions>();
  CLI::App& command = line.add(
      group, "figures",
      "Draws what a model has learned: substituted tokens, what actions change, where they move, "
      "clusters",
      "conceptplan inspect figures default --data data/concepts-validation --out docs/images",
      [options](Session& session) { return writeFigures(*options, session); });
  command.add_option("MODEL", options->model, "A shipped model's name, or a folder")->required();
  command
      .add_option("--data", options->data,
                  "Set of pictures of single objects, as generate concepts makes it")
      ->required()
      ->type_name("DIR");
  command.add_option("--out", options->out, "Folder of the SVG files")
      ->required()
      ->type_name("DIR");
  command.add_option("--pictures", options->pictures, "Most pictures read; 1000 if left out")
      ->check(inRange(20, 100000))
      ->type_name("N");
}

}  // namespace conceptplan::cli
