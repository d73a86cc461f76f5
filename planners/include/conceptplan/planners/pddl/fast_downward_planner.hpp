#pragma once

#include <filesystem>
#include <optional>

#include "conceptplan/planners/planner.hpp"
#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {

/// What Fast Downward does with the problem.
enum class FastDownwardSearch {
  kLmCut,      ///< A* with landmark cuts: a cheapest plan
  kBlind,      ///< uniform-cost search: a cheapest plan
  kLamaFirst,  ///< the first plan of LAMA
  kLama        ///< LAMA until it is done or the time is: better and better plans
};

struct FastDownwardOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  double step_discount = 0.01;       ///< as of `Determinisation`
  FastDownwardSearch search = FastDownwardSearch::kLmCut;
};

/// Fast Downward, another program, on the exported PDDL: runs it in a private temporary folder,
/// reads its plan files, and replays them on the graph; a plan that does not replay is a failure.
/// At the time limit, or when cancelled, it is killed with all that it started. The limit of
/// expansions is not passed on. Plans that are longer than the horizon are left out.
/// Source: M. Helmert, The Fast Downward planning system, 2006, doi:10.1613/jair.1705.
class FastDownwardPlanner final : public Planner {
 public:
  /// @param program an executable that takes the arguments of fast-downward.py
  /// @throws std::invalid_argument if an option is out of range.
  explicit FastDownwardPlanner(std::filesystem::path program,
                               const FastDownwardOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  std::filesystem::path program_;
  FastDownwardOptions options_;
};

/// The first `fast-downward`, else `fast-downward.py`, in the folders of the environment variable
/// PATH; nothing if there is none.
std::optional<std::filesystem::path> findFastDownward();

/// `fast-downward` by name, running that program.
PlannerEntry fastDownwardEntry(const std::filesystem::path& program);

/// Adds `fast-downward` if the program is found; else notes why it is missing.
/// @throws std::invalid_argument if the name is taken.
void addFastDownwardPlanner(PlannerRegistry& registry);

}  // namespace conceptplan
