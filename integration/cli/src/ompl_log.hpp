#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "console.hpp"

namespace conceptplan::cli {

/// What a benchmark log tells beside its runs.
struct OmplLogHeading {
  std::string experiment;  ///< one word
  std::string host = "unknown";
  std::string cpu;  ///< what is known of the processor; may be empty
  std::chrono::system_clock::time_point start;
  std::uint64_t seed = 0;
  double timeout_s = 0;   ///< of a search; 0 if unknown
  double duration_s = 0;  ///< of the whole experiment; 0 if unknown
};

/// A heading with this machine's name and processor, and the time that it is.
OmplLogHeading headingHere(const std::string& experiment);

/// Results of `solve` as a benchmark log of OMPL, which its script ompl_benchmark_statistics.py and
/// Planner Arena read. A scenario is a run; the set-up lists their names. `status` has the values
/// of `ompl::base::PlannerStatus`. Fields that a result lacks stay empty. Source: M. Moll, I. A.
/// Sucan and L. E. Kavraki, Benchmarking motion planning algorithms, 2015,
/// doi:10.1109/MRA.2015.2448276.
std::string toOmplLog(const std::vector<Json>& results, const OmplLogHeading& heading);

}  // namespace conceptplan::cli
