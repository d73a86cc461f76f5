#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "conceptplan/pipeline/model_manifest.hpp"

namespace conceptplan {

/// The names of the training profiles: "cpu" is what two cores learn within an hour; "paper" the
/// paper's networks on whole frames, with its losses and learning rates alone, which two cores
/// would train for weeks; "smoke" trains nothing useful in seconds, for tests, and "smoke-paper"
/// does so with the paper's networks.
std::vector<std::string> trainingProfiles();

struct TrainingOptions {
  std::filesystem::path data;        ///< datasets; those that are missing are generated here
  std::filesystem::path model;       ///< folder of the model
  std::filesystem::path start_from;  ///< model whose concept network is trained on; empty: none
  std::string profile = "cpu";
  std::uint64_t seed = 1;
  int jobs = 2;         ///< threads for generation and for Torch, on which the bytes depend
  bool resume = false;  ///< keep finished stages and go on from checkpoints
  bool anew = false;    ///< undo finished stages and checkpoints of what is trained
};

/// What training is doing.
struct TrainingProgress {
  std::string stage;      ///< e.g. "concepts", or "data: concepts-train"
  std::size_t done = 0;   ///< steps or pictures
  std::size_t total = 0;  ///< steps or pictures
  std::string message;    ///< the latest losses, or empty
  int stage_number = 1;   ///< the stage's number among those of the call, from 1
  int num_stages = 1;     ///< stages of the call
  double share = 0;       ///< of the time of this work that is done, 0 to 1
  /// What the call has done and has left to do, in typical time: `left / worked` of the time since
  /// the first report is left.
  double worked = 0;
  double left = 0;
};

struct TrainingControl {
  std::function<void(const TrainingProgress&)> progress;  ///< called now and then
  std::function<void(const std::string&)> warning;        ///< of what makes the model doubtful
  const std::atomic<bool>* cancel = nullptr;  ///< training ends soon after it turns true
};

/// Trains the stages in order. Each writes its file and the manifest when it is done; the long ones
/// write a checkpoint every minute and when cancelled. Losses go to MODEL/training.jsonl. Without
/// `resume`, the stages and those that build on them are made from nothing; where some of them are
/// finished or begun, `anew` must say so, and they are taken out of the model first. A wrong call
/// changes nothing.
/// Validation splits choose temperatures and name symbols; test splits are never read.
/// @returns whether all is done; false if cancelled
/// @throws InputError for a damaged dataset or model, a dataset made with another seed, size or
///   combination than the profile and `seed` ask for, data that are a dataset themselves, a model
///   begun with another seed or profile, one that would be undone without `anew`, a stage whose
///   predecessors are missing, an unknown profile, or a checkpoint of another run or number of jobs
/// @throws std::invalid_argument for both `resume` and `anew`
bool train(const std::vector<TrainingStage>& stages, const TrainingOptions& options,
           const TrainingControl& control);

}  // namespace conceptplan
