#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {

inline constexpr const char* kManifestName = "dataset.json";

/// dataset.json: what a folder holds.
struct Manifest {
  std::string kind;  ///< "tasks" or "concepts"
  nlohmann::json options;
  bool complete = false;
  std::uint32_t checksum = 0;  ///< of checksums.txt; 0 while incomplete
};

/// A line of checksums.txt.
struct FileChecksum {
  std::string path;  ///< relative to the folder, with '/'
  std::uint64_t bytes = 0;
  std::uint32_t crc32 = 0;
};

nlohmann::json toJson(const TaskDatasetOptions& options);
nlohmann::json toJson(const ConceptDatasetOptions& options);

/// @throws InputError with all faults.
TaskDatasetOptions taskOptions(const Manifest& manifest, const std::filesystem::path& folder);
ConceptDatasetOptions conceptOptions(const Manifest& manifest, const std::filesystem::path& folder);

/// @throws InputError if the file is missing, malformed, damaged or of another version.
Manifest readManifest(const std::filesystem::path& folder);

/// The manifest of a complete set of that kind. @throws InputError as above, and otherwise.
Manifest readManifest(const std::filesystem::path& folder, const std::string& kind);

/// @throws InputError with every option that differs, if the manifest is of another dataset.
void expectDataset(const Manifest& found, const std::filesystem::path& folder,
                   const std::string& kind, const nlohmann::json& options);

/// Whether a dataset was begun in the folder, which need not exist.
/// @throws InputError if there is something else in it.
bool wasBegun(const std::filesystem::path& folder);

/// Writes an incomplete manifest, or finds that one of the same kind and options is there. A
/// complete set becomes incomplete. @throws InputError if the folder holds something else.
void beginDataset(const std::filesystem::path& folder, const std::string& kind,
                  const nlohmann::json& options);

/// Writes checksums.txt for the files, and a complete manifest.
/// @param paths relative to the folder @throws InputError if one is missing
void finishDataset(const std::filesystem::path& folder, const std::string& kind,
                   const nlohmann::json& options, const std::vector<std::string>& paths);

/// The lines of checksums.txt. @throws InputError if it is missing or damaged.
std::vector<FileChecksum> readChecksums(const std::filesystem::path& folder,
                                        const Manifest& manifest);

/// What is wrong with a file of a dataset; empty if nothing.
std::vector<Fault> faultsOf(const std::filesystem::path& folder, const FileChecksum& expected);

}  // namespace conceptplan
