#include "commands.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/rendering/contact_sheet.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

struct GenerateImagesOptions {
  std::string out;
};

struct NamedPicture {
  std::string name;
  std::function<std::string(Renderer&)> png;
};

std::string pngOf(const Picture& picture) {
  return encodePng(picture.width, picture.height, picture.rgb);
}

/// The initial frame of the first test task of a level.
std::string levelFrame(Renderer& renderer, int level, std::uint64_t seed) {
  TaskOptions options;
  options.level = level;
  options.split = Split::kTest;
  options.seed = seed;
  const Task task = TaskGenerator(options).task(0);
  const RgbdImage image = renderer.render(task.initial, {task.appearance, RenderDomain::kStandard});
  return encodePng(image.width, image.height, image.rgb);
}

std::vector<NamedPicture> pictures(std::uint64_t seed) {
  const ContactSheetOptions options{{seed, RenderDomain::kStandard}};
  std::vector<NamedPicture> list{
      {"types-and-rotations",
       [options](Renderer& renderer) { return pngOf(rotationSheet(renderer, options)); }},
      {"colors-and-sizes", [options](Renderer& renderer) {
         return pngOf(colorAndSizeSheet(renderer, ObjectType::kCup, options));
       }}};
  for (int level = 1; level <= 4; ++level) {
    list.push_back({"level" + std::to_string(level), [level, seed](Renderer& renderer) {
                      return levelFrame(renderer, level, seed);
                    }});
  }
  return list;
}

int makeImages(const GenerateImagesOptions& options, Session& session) {
  createFolder(options.out);
  const std::vector<NamedPicture> list = pictures(session.options.seed);
  const auto progress = session.console.progress("pictures");
  Json files = Json::array();
  Renderer renderer;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (session.cancel) throw Interrupted{};
    progress(i, list.size());
    const std::filesystem::path file = std::filesystem::path(options.out) / (list[i].name + ".png");
    writeFileAtomically(file, list[i].png(renderer));
    files.push_back(file.string());
    session.console.print(file.string());
  }
  session.console.printJson({{"images", files}});
  return kDone;
}

}  // namespace

void addGenerateImagesCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<GenerateImagesOptions>();
  line.add(group, "images",
           "Contact sheets of types, rotations, colours and sizes, and a frame of each level",
           "conceptplan generate images --out docs/images",
           [options](Session& session) { return makeImages(*options, session); })
      .add_option("--out", options->out, "Folder of the pictures")
      ->required()
      ->type_name("DIR");
}

}  // namespace conceptplan::cli
