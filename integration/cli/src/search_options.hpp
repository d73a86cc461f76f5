#pragma once

#include "command_line.hpp"
#include "conceptplan/planners/planner.hpp"
#include "number_range.hpp"

namespace conceptplan::cli {

/// The options `--timeout`, `--expansions` and `--horizon` of a command that searches.
inline void addLimits(CLI::App& command, SearchLimits& limits) {
  command
      .add_option("--timeout", limits.timeout_s, "Seconds until a search gives up; 10 if left out")
      ->check(inRange(0.001, 1e6))
      ->type_name("S");
  command
      .add_option("--expansions", limits.max_expansions,
                  "Expansions after which a search gives up; 20000 if left out")
      ->check(inRange(1, 2000000000))
      ->type_name("N");
  command
      .add_option("--horizon", limits.horizon,
                  "Longest plan, in actions, for each target; 24 if left out")
      ->check(inRange(1, 1000))
      ->type_name("N");
}

}  // namespace conceptplan::cli
