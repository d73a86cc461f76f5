#include "commands.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

struct InspectModelOptions {
  std::string model;
};

/// Whether training told that symbols of the concept may be merged or split values.
bool isDoubtful(const ModelManifest& manifest, Concept which) {
  const auto found =
      manifest.measures.find("train/suspicious_clusters/" + std::string(name(which)));
  return found != manifest.measures.end() && found->second > 0;
}

/// A measure of the validation split, or null.
Json measure(const ModelManifest& manifest, const std::string& name) {
  const auto found = manifest.measures.find("validation/" + name);
  return found == manifest.measures.end() ? Json() : Json(found->second);
}

std::uintmax_t sizeOf(const Model& model) {
  std::uintmax_t bytes = 0;
  for (const auto& [file, checksum] : model.manifest().files) {
    bytes += std::filesystem::file_size(model.folder() / file);
  }
  return bytes;
}

Json conceptsJson(const Model& model) {
  Json list = Json::array();
  for (const Concept which : kConcepts) {
    Json values = Json::array();
    const std::size_t count = model.symbolic().cardinality()[index(which)];
    for (std::size_t symbol = 0; symbol < count; ++symbol) {
      values.push_back(
          model.symbolic().grounding.name(which, SymbolId{static_cast<std::int32_t>(symbol)}));
    }
    const std::string concept_name(name(which));
    list.push_back(
        {{"name", concept_name},
         {"values", values},
         {"accuracy", measure(model.manifest(), "accuracy/" + concept_name)},
         {"calibration_error", measure(model.manifest(), "calibration_error/" + concept_name)},
         {"suspicious_clusters", isDoubtful(model.manifest(), which)}});
  }
  return list;
}

Json actionsJson(const Model& model) {
  Json list = Json::array();
  for (const ActionDescription& action : describe(model.symbolic())) {
    list.push_back({{"name", name(action.action)},
                    {"needs", action.needs},
                    {"does", action.does},
                    {"probability", action.probability}});
  }
  return list;
}

/// Disentanglement measures, by their names in the manifest; "dci" is the D of DCI.
Json measuresJson(const ModelManifest& manifest) {
  Json measures{{"split", "validation"}};
  for (const char* name :
       {"dci", "dci_completeness", "dci_informativeness", "mig", "sap", "factor_vae", "beta_vae"}) {
    measures[name] = measure(manifest, name);
  }
  return measures;
}

void print(const Json& document, Console& console) {
  const auto figure = [](const Json& value) {
    return value.is_number() ? decimal(value, 4) : std::string("-");
  };
  console.print("model " + document["name"].get<std::string>() + ", format " +
                document["format"].dump() + ", " + document["parameters"].dump() + " parameters, " +
                document["bytes"].dump() + " bytes");
  TextTable concepts{{"concept", "accuracy (validation)", "calibration error", "values"}};
  for (const Json& entry : document["concepts"]) {
    std::string values;
    for (const Json& value : entry["values"]) {
      values += (values.empty() ? "" : ", ") + value.get<std::string>();
    }
    concepts.push_back(
        {entry["name"], figure(entry["accuracy"]), figure(entry["calibration_error"]), values});
  }
  console.print(concepts);
  for (const Json& entry : document["concepts"]) {
    if (entry["suspicious_clusters"].get<bool>()) {
      console.print("warning: symbols of " + entry["name"].get<std::string>() +
                    " may be merged or split values");
    }
  }
  TextTable actions{{"action", "does", "needs", "probability"}};
  for (const Json& entry : document["actions"]) {
    actions.push_back({entry["name"], entry["does"], entry["needs"], figure(entry["probability"])});
  }
  console.print(actions);
  TextTable measures{{"disentanglement (validation)", "score"}};
  for (const auto& [name, score] : document["measures"].items()) {
    if (name != "split") measures.push_back({name, figure(score)});
  }
  console.print(measures);
}

int inspectModel(const InspectModelOptions& options, Session& session) {
  const Model model(findModel(options.model));
  const Json document{{"name", model.manifest().name},
                      {"format", kModelFormat},
                      {"split", "validation"},
                      {"concepts", conceptsJson(model)},
                      {"actions", actionsJson(model)},
                      {"measures", measuresJson(model.manifest())},
                      {"parameters", model.numParameters()},
                      {"bytes", sizeOf(model)},
                      {"profile", model.manifest().profile},
                      {"seed", model.manifest().seed},
                      {"revision", model.manifest().revision}};
  session.console.printJson(document);
  print(document, session.console);
  return kDone;
}

}  // namespace

void addInspectModelCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<InspectModelOptions>();
  line.add(group, "model", "What a model has learned: its concepts and actions",
           "conceptplan inspect model default",
           [options](Session& session) { return inspectModel(*options, session); })
      .add_option("MODEL", options->model, "A shipped model's name, or a folder")
      ->required();
}

void addInspectCommands(CommandLine& line) {
  CLI::App& group = line.addGroup("inspect", "Show what is inside a model, dataset or scenario");
  addInspectModelCommand(line, group);
  addInspectDatasetCommand(line, group);
  addInspectFiguresCommand(line, group);
  addInspectScenarioCommand(line, group);
}

}  // namespace conceptplan::cli
