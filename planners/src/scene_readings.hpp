#pragma once

#include <vector>

#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// One way to read the objects beside the target.
struct SceneReading {
  std::vector<Symbols> others;
  double share = 0;
};

/// The probable readings of the other objects as far as they matter to a plan; shares sum to one.
/// The first has the most probable symbols; the rest come by falling share. TYPE symbols that no
/// effect takes symbols from count as one.
std::vector<SceneReading> probableReadings(const SymbolicModel& model, const SymbolicScene& scene,
                                           const CompileOptions& options);

}  // namespace conceptplan
