#pragma once

#include <memory>

#include "conceptplan/planners/symbol_graph.hpp"
#include "planners/learned_world.hpp"
#include "planners/sample_tasks.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan::testing {

/// A task as the learned model sees it.
inline std::shared_ptr<const SymbolGraph> graphOf(const Task& task) {
  return std::make_shared<SymbolGraph>(
      compile(learnedModel(), learnedRelabelling().problem(task), GridValidity()));
}

/// A task of the tiny world.
inline std::shared_ptr<const SymbolGraph> tinyGraph(const Symbols& start, const Symbols& goal) {
  return std::make_shared<SymbolGraph>(
      compile(tinyModel(), tinyProblem(start, goal), GridValidity()));
}

}  // namespace conceptplan::testing
