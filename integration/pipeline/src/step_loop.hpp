#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "training_stages.hpp"

namespace conceptplan::training {

/// Steps of two phases that take different times.
struct Phases {
  std::int64_t first;  ///< steps of the first phase
  double cost;         ///< of one of these, in steps of the second phase

  /// The share of the time of all `steps` that `done` take.
  double share(std::int64_t done, std::int64_t steps) const {
    const auto time = [this](std::int64_t count) {
      const auto early = static_cast<double>(std::min(count, first));
      return static_cast<double>(count) + (cost - 1) * early;
    };
    return steps > 0 ? time(done) / time(steps) : 1;
  }
};

/// Runs a trainer's steps until all are done or the run is cancelled, with progress, a log line
/// every hundred steps, and a checkpoint at the profile's interval. `trainer` has step(),
/// stepsDone(), stepsInAll(), checkpoint() and restore(). `phases_of` gives the phases, which may
/// become longer, and `describe` the JSON of the latest losses.
/// @returns false if cancelled. @throws InputError for a checkpoint of another run.
template <typename Trainer, typename PhasesOf, typename Describe>
bool runSteps(const Run& run, TrainingStage stage, Trainer& trainer, const PhasesOf& phases_of,
              const Describe& describe) {
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t kLogEvery = 100;
  const auto path = run.checkpoint(stage);
  if (run.options.resume && std::filesystem::exists(path)) try {
      trainer.restore(readFile(path), path);
    } catch (const InputError&) {
      throw;
    } catch (const std::exception&) {
      throw InputError(
          {{path.string(), std::nullopt, std::nullopt, "",
            "is not a checkpoint of this stage and profile; remove it to begin anew"}});
    }
  auto saved = Clock::now();
  while (trainer.stepsDone() < trainer.stepsInAll()) {
    if (run.cancelled()) {
      writeFileAtomically(path, trainer.checkpoint());
      return false;
    }
    const std::string losses = describe(trainer.step());
    const std::int64_t done = trainer.stepsDone();
    const std::int64_t steps = trainer.stepsInAll();
    run.report({std::string(name(stage)), static_cast<std::size_t>(done),
                static_cast<std::size_t>(steps), losses},
               phases_of().share(done, steps));
    if (done % kLogEvery == 0)
      run.log("{\"stage\":\"" + std::string(name(stage)) + "\",\"step\":" + std::to_string(done) +
              ",\"losses\":" + losses + "}");
    if (Clock::now() - saved > run.profile.checkpoint_interval) {
      writeFileAtomically(path, trainer.checkpoint());
      saved = Clock::now();
    }
  }
  return true;
}

}  // namespace conceptplan::training
