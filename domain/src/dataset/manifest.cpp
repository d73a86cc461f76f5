#include "dataset/manifest.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/domain/files/json_depth.hpp"
#include "dataset/json_fields.hpp"

namespace conceptplan {
namespace {

constexpr int kVersion = 1;
constexpr const char* kChecksumsName = "checksums.txt";

[[noreturn]] void fail(const std::filesystem::path& path, std::string message) {
  throw InputError({{path.string(), {}, {}, "", std::move(message)}});
}

Fault origin(const std::filesystem::path& folder) {
  return {(folder / kManifestName).string(), {}, {}, "", ""};
}

void writeManifest(const std::filesystem::path& folder, const Manifest& manifest) {
  nlohmann::ordered_json document;
  document["conceptplan_dataset"] = kVersion;
  document["kind"] = manifest.kind;
  document["options"] = manifest.options;
  document["complete"] = manifest.complete;
  document["checksums"] = hexadecimal(manifest.checksum);
  document["checksum"] = hexadecimal(crc32OfJson(document.dump()));
  writeFileAtomically(folder / kManifestName, document.dump(2) + '\n');
}

/// A number of hexadecimal digits; nothing if it is none.
std::optional<std::uint32_t> parseHexadecimal(const std::string& digits) {
  if (digits.size() != 8 || digits.find_first_not_of("0123456789abcdef") != std::string::npos)
    return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16));
}

}  // namespace

nlohmann::json toJson(const TaskDatasetOptions& options) {
  return {{"levels", options.levels},
          {"count", options.count},
          {"split", name(options.split)},
          {"objects", name(options.objects)},
          {"combination", name(options.combination)},
          {"domain", name(options.domain)},
          {"frames", name(options.frames)},
          {"seed", options.seed}};
}

nlohmann::json toJson(const ConceptDatasetOptions& options) {
  return {{"split", name(options.split)},
          {"samples", options.samples},
          {"domain", name(options.domain)},
          {"seed", options.seed}};
}

TaskDatasetOptions taskOptions(const Manifest& manifest, const std::filesystem::path& folder) {
  std::vector<Fault> faults;
  JsonFields fields(manifest.options, origin(folder), faults, "options.");
  TaskDatasetOptions options;
  options.levels.clear();
  const nlohmann::json& named = fields.at("levels");
  const bool is_list = named.is_array() && !named.empty();
  if (!is_list && !named.is_null()) fields.fault("levels", "expected a list of levels");
  for (const nlohmann::json& level : is_list ? named : nlohmann::json::array()) {
    if (!level.is_number_unsigned() || level < 1 || level > 4) {
      fields.fault("levels", "expected levels in [1, 4], found " + level.dump());
    } else if (std::ranges::count(options.levels, level.get<int>()) > 0) {
      fields.fault("levels", "level " + level.dump() + " is named twice");
    } else {
      options.levels.push_back(level.get<int>());
    }
  }
  options.count = fields.integer("count", 1, std::numeric_limits<int>::max());
  options.split = fields.choice("split", splitNamed);
  options.objects = fields.choice("objects", objectSetNamed);
  options.combination = fields.choice("combination", combinationNamed);
  options.domain = fields.choice("domain", renderDomainNamed);
  options.frames = fields.choice("frames", framesNamed);
  options.seed = fields.unsignedInteger("seed");
  fields.rejectOthers();
  if (!faults.empty()) throw InputError(std::move(faults));
  return options;
}

ConceptDatasetOptions conceptOptions(const Manifest& manifest,
                                     const std::filesystem::path& folder) {
  std::vector<Fault> faults;
  JsonFields fields(manifest.options, origin(folder), faults, "options.");
  ConceptDatasetOptions options;
  options.split = fields.choice("split", splitNamed);
  options.samples = fields.integer("samples", 1, kNumColorSamples);
  options.domain = fields.choice("domain", renderDomainNamed);
  options.seed = fields.unsignedInteger("seed");
  fields.rejectOthers();
  if (!faults.empty()) throw InputError(std::move(faults));
  return options;
}

Manifest readManifest(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kManifestName;
  const std::string text = readFile(path);
  if (nestsTooDeep(text)) fail(path, "is nested too deeply");
  const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
  if (document.is_discarded()) fail(path, "is not valid JSON");
  std::vector<Fault> faults;
  JsonFields fields(document, origin(folder), faults);
  const nlohmann::json& version = fields.at("conceptplan_dataset");
  if (!version.is_null() && version != kVersion)
    fail(path,
         "expected a dataset of version " + std::to_string(kVersion) + ", found " + version.dump());
  const std::string expected = fields.text("checksum"), found = hexadecimal(crc32OfJson(text));
  if (faults.empty() && expected != found)
    fail(path, "is damaged: expected checksum " + expected + ", found " + found);
  Manifest manifest;
  manifest.kind = fields.text("kind");
  if (manifest.kind != "tasks" && manifest.kind != "concepts")
    fields.fault("kind", "expected \"tasks\" or \"concepts\", found \"" + manifest.kind + '"');
  manifest.options = fields.at("options");
  manifest.complete = fields.boolean("complete");
  const std::optional<std::uint32_t> checksum = parseHexadecimal(fields.text("checksums"));
  if (!checksum) fields.fault("checksums", "expected eight hexadecimal digits");
  manifest.checksum = checksum.value_or(0);
  fields.rejectOthers();
  if (!faults.empty()) throw InputError(std::move(faults));
  return manifest;
}

Manifest readManifest(const std::filesystem::path& folder, const std::string& kind) {
  Manifest manifest = readManifest(folder);
  const std::filesystem::path path = folder / kManifestName;
  if (manifest.kind != kind)
    fail(path, "expected a dataset of " + kind + ", found one of " + manifest.kind);
  if (!manifest.complete)
    fail(path, "the generation was interrupted; the same generate command continues it");
  return manifest;
}

void expectDataset(const Manifest& found, const std::filesystem::path& folder,
                   const std::string& kind, const nlohmann::json& options) {
  if (found.kind == kind && found.options == options) return;
  std::vector<Fault> faults{
      {folder.string(), {}, {}, "", "holds another dataset; remove it or choose another folder"}};
  const auto differs = [&](const std::string& key, const std::string& expected,
                           const std::string& there) {
    faults.push_back({(folder / kManifestName).string(),
                      {},
                      {},
                      key,
                      "expected " + expected + ", found " + there});
  };
  if (found.kind != kind) {
    differs("kind", '"' + kind + '"', '"' + found.kind + '"');
  } else {
    const auto text = [](const nlohmann::json& from, const std::string& key) {
      return from.is_object() && from.contains(key) ? from[key].dump() : std::string("nothing");
    };
    for (const auto& option : options.items())
      if (text(found.options, option.key()) != text(options, option.key()))
        differs("options." + option.key(), text(options, option.key()),
                text(found.options, option.key()));
  }
  throw InputError(std::move(faults));
}

bool wasBegun(const std::filesystem::path& folder) {
  if (std::filesystem::exists(folder / kManifestName)) return true;
  if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder))
    fail(folder, "is neither empty nor a dataset");
  return false;
}

void beginDataset(const std::filesystem::path& folder, const std::string& kind,
                  const nlohmann::json& options) {
  createFolder(folder);
  if (wasBegun(folder)) expectDataset(readManifest(folder), folder, kind, options);
  writeManifest(folder, {kind, options, false, 0});
}

void finishDataset(const std::filesystem::path& folder, const std::string& kind,
                   const nlohmann::json& options, const std::vector<std::string>& paths) {
  std::string lines;
  for (const std::string& path : paths) {
    const std::uint32_t checksum = crc32OfFile(folder / path);
    lines += hexadecimal(checksum) + ' ' +
             std::to_string(std::filesystem::file_size(folder / path)) + ' ' + path + '\n';
  }
  writeFileAtomically(folder / kChecksumsName, lines);
  writeManifest(folder, {kind, options, true, crc32(lines)});
}

std::vector<FileChecksum> readChecksums(const std::filesystem::path& folder,
                                        const Manifest& manifest) {
  const std::filesystem::path path = folder / kChecksumsName;
  const std::string text = readFile(path);
  if (crc32(text) != manifest.checksum)
    fail(path, "is damaged: expected checksum " + hexadecimal(manifest.checksum) + ", found " +
                   hexadecimal(crc32(text)));
  std::vector<FileChecksum> checksums;
  std::istringstream lines(text);
  std::string digits;
  FileChecksum line;
  while (lines >> digits >> line.bytes >> line.path) {
    line.crc32 = parseHexadecimal(digits).value_or(0);
    checksums.push_back(line);
  }
  return checksums;
}

std::vector<Fault> faultsOf(const std::filesystem::path& folder, const FileChecksum& expected) {
  const std::filesystem::path path = folder / expected.path;
  try {
    const std::uint32_t checksum = crc32OfFile(path);
    const std::uint64_t bytes = std::filesystem::file_size(path);
    if (bytes != expected.bytes)
      return {{path.string(),
               {},
               {},
               "",
               "expected " + std::to_string(expected.bytes) + " bytes, found " +
                   std::to_string(bytes)}};
    if (checksum != expected.crc32)
      return {{path.string(),
               {},
               {},
               "",
               "is damaged: expected checksum " + hexadecimal(expected.crc32) + ", found " +
                   hexadecimal(checksum)}};
    return {};
  } catch (const InputError& error) {
    return error.faults();
  }
}

}  // namespace conceptplan
