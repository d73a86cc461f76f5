#pragma once

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/planners/state_validity.hpp"
#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// What a graph was compiled from, but for its problem. A graph does not keep it; a query hands it
/// on, so that the problem can be compiled again without the objects that seem to block the way.
struct GraphSource {
  const SymbolicModel& model;
  const StateValidity& validity;
  CompileOptions options = {};
};

}  // namespace conceptplan
