#include "conceptplan/pipeline/model_manifest.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/domain/files/json_depth.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

using Json = nlohmann::json;

constexpr std::array kStages{TrainingStage::kLearnConcepts, TrainingStage::kMakeSymbols,
                             TrainingStage::kCountTransitions, TrainingStage::kTrainVict};

/// The manifest of well-formed JSON; faults name what is missing or of a wrong type.
/// @param checksum of what the JSON says
ModelManifest parse(const Json& json, const std::string& checksum,
                    const std::filesystem::path& path, std::vector<Fault>& faults) {
  const auto fault = [&](const std::string& key, const std::string& message) {
    faults.push_back({path.string(), std::nullopt, std::nullopt, key, message});
  };
  ModelManifest manifest;
  if (!json.contains("conceptplan_model") || json["conceptplan_model"] != kModelFormat) {
    fault("conceptplan_model",
          "expected format " + std::to_string(kModelFormat) + ", found " +
              (json.contains("conceptplan_model") ? json["conceptplan_model"].dump()
                                                  : std::string("none")));
    return manifest;
  }
  const auto expected = json.find("checksum");
  if (expected == json.end()) {
    fault("checksum", "is missing");
  } else if (*expected != checksum) {
    fault("", "is damaged: expected checksum " + expected->dump() + ", found \"" + checksum + '"');
    return manifest;
  }
  const auto read = [&](const char* key, auto& into) {
    try {
      json.at(key).get_to(into);
    } catch (const Json::exception&) {
      fault(key, "missing or of a wrong type");
    }
  };
  std::string encoder;
  std::vector<std::string> stages;
  read("name", manifest.name);
  read("profile", manifest.profile);
  read("encoder", encoder);
  read("seed", manifest.seed);
  read("revision", manifest.revision);
  read("data", manifest.data);
  read("stages", stages);
  read("measures", manifest.measures);
  read("files", manifest.files);
  if (const auto kind = encoderKindNamed(encoder))
    manifest.encoder = *kind;
  else
    fault("encoder", "expected object-centred or full-frame, found \"" + encoder + "\"");
  for (const TrainingStage stage : kStages)
    if (std::find(stages.begin(), stages.end(), name(stage)) != stages.end())
      manifest.stages.push_back(stage);
  if (manifest.stages.size() != stages.size()) fault("stages", "holds an unknown stage");
  for (const auto& entry : manifest.files) {
    const std::string& file = entry.first;
    if (std::none_of(manifest.stages.begin(), manifest.stages.end(), [&](TrainingStage stage) {
          const std::vector<const char*> known = filesOf(stage);
          return std::find(known.begin(), known.end(), file) != known.end();
        }))
      fault("files", "\"" + file + "\" is of no stage that is done");
  }
  return manifest;
}

}  // namespace

std::vector<const char*> filesOf(TrainingStage stage) {
  switch (stage) {
    case TrainingStage::kLearnConcepts:
      return {kConceptsFile};
    case TrainingStage::kMakeSymbols:
      return {kSymbolsFile};
    case TrainingStage::kCountTransitions:
      return {kTransitionsFile};
    case TrainingStage::kTrainVict:
      return {kVictFile};
  }
  return {};
}

std::string_view name(TrainingStage stage) {
  switch (stage) {
    case TrainingStage::kLearnConcepts:
      return "concepts";
    case TrainingStage::kMakeSymbols:
      return "symbols";
    case TrainingStage::kCountTransitions:
      return "transitions";
    case TrainingStage::kTrainVict:
      return "vict";
  }
  return "";
}

bool ModelManifest::has(TrainingStage stage) const {
  return std::find(stages.begin(), stages.end(), stage) != stages.end();
}

ModelManifest readModelManifest(const std::filesystem::path& folder,
                                std::optional<TrainingStage> remade) {
  const auto path = folder / kModelManifestFile;
  const std::string text = readFile(path);
  const Json json =
      nestsTooDeep(text) ? Json() : Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object())
    throw InputError({{path.string(), std::nullopt, std::nullopt, "", "is not a JSON object"}});
  std::vector<Fault> faults;
  ModelManifest manifest = parse(json, hexadecimal(crc32OfJson(text)), path, faults);
  for (const TrainingStage stage : manifest.stages) {
    if (remade && stage >= *remade) break;
    for (const char* file : filesOf(stage)) {
      const auto file_path = folder / file;
      const auto expected = manifest.files.find(file);
      try {
        const std::string found = hexadecimal(crc32OfFile(file_path));
        if (expected == manifest.files.end() || expected->second != found)
          faults.push_back(
              {file_path.string(), std::nullopt, std::nullopt, "",
               "is damaged: expected checksum " +
                   (expected == manifest.files.end() ? "in the manifest" : expected->second) +
                   ", found " + found});
      } catch (const InputError& error) {
        faults.insert(faults.end(), error.faults().begin(), error.faults().end());
      }
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return manifest;
}

void writeModelManifest(const std::filesystem::path& folder, ModelManifest manifest) {
  manifest.files.clear();
  Json stages = Json::array();
  for (const TrainingStage stage : manifest.stages) {
    stages.push_back(name(stage));
    for (const char* file : filesOf(stage))
      manifest.files[file] = hexadecimal(crc32OfFile(folder / file));
  }
  Json json{{"conceptplan_model", kModelFormat},
            {"name", manifest.name},
            {"profile", manifest.profile},
            {"encoder", name(manifest.encoder)},
            {"seed", manifest.seed},
            {"revision", manifest.revision},
            {"data", manifest.data},
            {"stages", stages},
            {"measures", manifest.measures},
            {"files", manifest.files}};
  json["checksum"] = hexadecimal(crc32OfJson(json.dump()));
  writeFileAtomically(folder / kModelManifestFile, json.dump(2) + "\n");
}

}  // namespace conceptplan
