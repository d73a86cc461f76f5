#include "conceptplan/planners/pddl/fast_downward_planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "child_process.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/program_path.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/planners/path_planning.hpp"
#include "conceptplan/planners/pddl/pddl_export.hpp"
#include "conceptplan/planners/pddl/plan_replay.hpp"
#include "option_range.hpp"

namespace conceptplan {
namespace {

// Exit codes of Fast Downward, https://www.fast-downward.org/latest/documentation/exit-codes/
constexpr int kMostSuccess = 3;
constexpr int kTranslateUnsolvable = 10;
constexpr int kSearchUnsolvable = 11;
constexpr int kSearchIncomplete = 12;
constexpr int kTranslateOutOfMemory = 20;
constexpr int kTranslateOutOfTime = 21;
constexpr int kSearchOutOfMemory = 22;
constexpr int kSearchOutOfTime = 23;
constexpr int kSearchOutOfMemoryAndTime = 24;

constexpr const char* kPlanFile = "sas_plan";

std::vector<std::string> argumentsOf(FastDownwardSearch search, double timeout_s) {
  const auto seconds = static_cast<long long>(std::ceil(std::min(timeout_s, 1e6)));
  std::vector<std::string> arguments{"--overall-time-limit", std::to_string(seconds) + "s",
                                     "--plan-file", kPlanFile};
  const auto add = [&arguments](std::vector<std::string> more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
  };
  if (search == FastDownwardSearch::kLamaFirst) add({"--alias", "lama-first"});
  if (search == FastDownwardSearch::kLama) add({"--alias", "seq-sat-lama-2011"});
  add({"domain.pddl", "problem.pddl"});
  if (search == FastDownwardSearch::kLmCut) add({"--search", "astar(lmcut())"});
  if (search == FastDownwardSearch::kBlind) add({"--search", "astar(blind())"});
  return arguments;
}

/// sas_plan, sas_plan.1, sas_plan.2, ... that are there.
std::vector<std::filesystem::path> planFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name == kPlanFile || name.starts_with(std::string(kPlanFile) + ".")) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The last line of a text that is not empty.
std::string lastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return "it wrote nothing";
  const std::size_t newline = text.find_last_of('\n', end);
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  return text.substr(begin, end - begin + 1);
}

/// The number N in the last line "... Expanded N state(s)."; 0 if there is none.
std::size_t expansionsIn(const std::string& log) {
  const std::size_t at = log.rfind("Expanded ");
  return at == std::string::npos ? 0 : std::strtoull(log.c_str() + at + 9, nullptr, 10);
}

/// One run of the program on one problem.
class FastDownwardRun {
 public:
  FastDownwardRun(const PathTask& task, const FastDownwardOptions& options)
      : task_(task), options_(options) {}

  std::vector<StatePath> paths(const std::filesystem::path& program) {
    const std::filesystem::path& folder = folder_.path();
    const PddlText text = toPddl(task_.graph, {"task", determinisation(), {}});
    writeFileAtomically(folder / "domain.pddl", text.domain);
    writeFileAtomically(folder / "problem.pddl", text.problem);
    const SearchLimits& limits = task_.query.limits;
    const ChildExit ending =
        runChild({program, argumentsOf(options_.search, limits.timeout_s), folder, folder / "log"},
                 limits.timeout_s, limits.cancel);
    log_ = readFile(folder / "log");
    task_.statistics.expanded = expansionsIn(log_);
    stopAfter(ending);
    return bestPaths(ending.timed_out || ending.cancelled);
  }

 private:
  Determinisation determinisation(
      std::int64_t cost_per_nat = Determinisation{}.cost_per_nat) const {
    return {options_.legality_threshold, options_.step_discount, cost_per_nat};
  }

  void fail(const std::string& reason) {
    task_.guard.stop(PlanStatus::kFailed, "fast-downward " + reason);
  }

  /// Tells the guard of an end that is neither a plan nor a proof that there is none.
  void stopAfter(const ChildExit& ending) {
    if (ending.cancelled) {
      task_.guard.stop(PlanStatus::kLimit, "cancelled");
    } else if (ending.timed_out || ending.code == kTranslateOutOfTime ||
               ending.code == kSearchOutOfTime) {
      task_.guard.stop(PlanStatus::kTimeout, "fast-downward stopped at the time limit of " +
                                                 std::to_string(task_.query.limits.timeout_s) +
                                                 " s");
    } else if (ending.code == kTranslateOutOfMemory || ending.code == kSearchOutOfMemory ||
               ending.code == kSearchOutOfMemoryAndTime) {
      task_.guard.stop(PlanStatus::kLimit, "fast-downward ran out of memory");
    } else if (ending.code == kSearchIncomplete) {
      task_.guard.stop(PlanStatus::kLimit, "fast-downward gave up");
    } else if (!ending.code) {
      fail("was ended by a signal: " + lastLine(log_));
    } else if (*ending.code > kMostSuccess && *ending.code != kTranslateUnsolvable &&
               *ending.code != kSearchUnsolvable) {
      fail("ended with exit code " + std::to_string(*ending.code) + ": " + lastLine(log_));
    } else if (*ending.code <= kMostSuccess && planFiles(folder_.path()).empty()) {
      fail("wrote no plan: " + lastLine(log_));
    }
  }

  /// The plans written, replayed, best first; none if one of them is wrong.
  /// @param killed the last file may be torn
  std::vector<StatePath> bestPaths(bool killed) {
    std::vector<StatePath> paths;
    std::size_t too_long = 0;
    for (const std::filesystem::path& file : planFiles(folder_.path())) {
      try {
        StatePath path = replayed(readPlanFile(file));
        if (path.actions.size() > task_.query.limits.horizon) {
          too_long = path.actions.size();
        } else if (std::none_of(paths.begin(), paths.end(), [&path](const StatePath& known) {
                     return known.actions == path.actions;
                   })) {
          paths.push_back(std::move(path));
        }
      } catch (const InputError& error) {
        if (killed) continue;
        fail("wrote a wrong plan: " + error.faults().front().message);
        return {};
      }
    }
    if (paths.empty() && too_long > 0) {
      task_.guard.stop(PlanStatus::kLimit, "the plan of fast-downward has " +
                                               std::to_string(too_long) +
                                               " actions, which is beyond the horizon of " +
                                               std::to_string(task_.query.limits.horizon));
    }
    std::stable_sort(paths.begin(), paths.end(), [](const StatePath& a, const StatePath& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.actions.size() < b.actions.size();
    });
    if (paths.size() > task_.query.top) paths.resize(task_.query.top);
    return paths;
  }

  /// @throws InputError if it does not replay.
  StatePath replayed(const PlanFile& plan) const {
    const PlanReplay result = replay(task_.graph, plan.steps, determinisation(kNat));
    if (result.failure) {
      throw InputError(
          {{"",
            {},
            {},
            "",
            "step " + std::to_string(result.failure->step + 1) + ": " + result.failure->reason}});
    }
    StatePath path{{}, result.states, result.cost};
    for (const PlanFileStep& step : plan.steps) path.actions.push_back(step.action);
    return path;
  }

  const PathTask& task_;
  const FastDownwardOptions& options_;
  const PrivateFolder folder_;
  std::string log_;
};

std::optional<FastDownwardSearch> searchNamed(const std::string& name) {
  if (name == "lmcut") return FastDownwardSearch::kLmCut;
  if (name == "blind") return FastDownwardSearch::kBlind;
  if (name == "lama-first") return FastDownwardSearch::kLamaFirst;
  if (name == "lama") return FastDownwardSearch::kLama;
  return std::nullopt;
}

}  // namespace

FastDownwardPlanner::FastDownwardPlanner(std::filesystem::path program,
                                         const FastDownwardOptions& options)
    : program_(std::move(program)), options_(options) {
  checkOptionRange("legality_threshold", options_.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options_.step_discount, 0, 0.5);
}

PlanResult FastDownwardPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPaths(graph, query, options_.legality_threshold,
                     [this](const PathTask& task) -> std::vector<StatePath> {
                       try {
                         return FastDownwardRun(task, options_).paths(program_);
                       } catch (const std::runtime_error& error) {
                         task.guard.stop(PlanStatus::kFailed, error.what());
                         return {};
                       }
                     });
}

std::optional<std::filesystem::path> findFastDownward() {
  const auto program = findOnPath("fast-downward");
  return program ? program : findOnPath("fast-downward.py");
}

PlannerEntry fastDownwardEntry(const std::filesystem::path& program) {
  return {
      "fast-downward",
      "The program Fast Downward on the exported PDDL; there if it is on the PATH.",
      "M. Helmert, The Fast Downward planning system, 2006, doi:10.1613/jair.1705; landmark cuts: "
      "M. Helmert and C. Domshlak, ICAPS 2009; LAMA: S. Richter and M. Westphal, 2010, "
      "doi:10.1613/jair.2972.",
      {"Every plan replays on the compiled graph, where each action has its most probable outcome; "
       "a plan that does not is a failure.",
       "With lmcut and blind one plan, the best one, with costs in millionths of a nat; with "
       "lama-first one plan, with lama several by rising cost, none need be the best. A plan "
       "beyond "
       "the horizon is left out, and nothing proved.",
       "infeasible is what the program says it has proved; giving up is limit or timeout. The time "
       "limit kills it; the limit of expansions is not passed on."},
      {PlannerOption::legalityThreshold(), PlannerOption::stepDiscount(),
       PlannerOption::choice("search", {"lmcut", "blind", "lama-first", "lama"},
                             "A* with landmark cuts, uniform-cost search, the first plan of LAMA, "
                             "or LAMA until it is done or the time is")},
      [program](const OptionValues& values) -> std::unique_ptr<Planner> {
        return std::make_unique<FastDownwardPlanner>(
            program,
            FastDownwardOptions{values.number("legality_threshold"), values.number("step_discount"),
                                searchNamed(values.choice("search")).value()});
      }};
}

void addFastDownwardPlanner(PlannerRegistry& registry) {
  if (const auto program = findFastDownward()) {
    registry.add(fastDownwardEntry(*program));
  } else {
    registry.addMissing("fast-downward",
                        "needs the program fast-downward or fast-downward.py on the PATH; "
                        "https://www.fast-downward.org has it");
  }
}

}  // namespace conceptplan
