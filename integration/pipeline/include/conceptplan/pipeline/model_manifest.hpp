#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "conceptplan/learner/encoder_kind.hpp"

namespace conceptplan {

/// Version of the model folder's format.
inline constexpr int kModelFormat = 5;

/// A stage of training, in the order in which they build on each other.
enum class TrainingStage { kLearnConcepts, kMakeSymbols, kCountTransitions, kTrainVict };
inline constexpr int kNumTrainingStages = 4;

/// "concepts", "symbols", "transitions" or "vict".
std::string_view name(TrainingStage stage);

/// The names of the files that a stage makes.
std::vector<const char*> filesOf(TrainingStage stage);

/// What a model folder says of itself, in manifest.json.
struct ModelManifest {
  std::string name;  ///< of the folder
  std::string profile;
  EncoderKind encoder = EncoderKind::kObjectCentred;
  std::uint64_t seed = 0;
  std::string revision;                      ///< of the program's source, or "unknown"
  std::map<std::string, std::string> data;   ///< dataset -> checksum of its dataset.json
  std::vector<TrainingStage> stages;         ///< those that are done
  std::map<std::string, double> measures;    ///< e.g. "validation/accuracy/TYPE"
  std::map<std::string, std::string> files;  ///< name -> CRC-32 of its bytes

  bool has(TrainingStage stage) const;
};

/// Files of a model folder.
inline constexpr const char* kConceptsFile = "concepts.safetensors";
inline constexpr const char* kSymbolsFile = "symbols.safetensors";
inline constexpr const char* kTransitionsFile = "symbolic_model.json";
inline constexpr const char* kVictFile = "vict.safetensors";
inline constexpr const char* kModelManifestFile = "manifest.json";

/// Reads FOLDER/manifest.json and checks that it and every file that it names is there and
/// unchanged.
/// @param remade files of that stage and of later ones may be lost or damaged: they are made anew
/// @throws InputError with all faults.
ModelManifest readModelManifest(const std::filesystem::path& folder,
                                std::optional<TrainingStage> remade = std::nullopt);

/// Writes it atomically, with the checksums of the files as they are now.
/// @throws InputError, std::runtime_error as `writeFileAtomically`.
void writeModelManifest(const std::filesystem::path& folder, ModelManifest manifest);

}  // namespace conceptplan
