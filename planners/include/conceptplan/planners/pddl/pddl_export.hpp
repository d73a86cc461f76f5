#pragma once

#include <array>
#include <string>
#include <vector>

#include "conceptplan/planners/pddl/determinisation.hpp"
#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

struct PddlOptions {
  std::string name = "conceptplan";  ///< of domain and problem; letters and digits of it are kept
  Determinisation determinisation;
  /// What a person calls the symbols, for comments; may be empty. As `SymbolGrounding::names`.
  std::array<std::vector<std::string>, kNumConcepts> symbol_names;
};

/// A problem as two files.
struct PddlText {
  std::string domain;
  std::string problem;
};

/// The problem with most probable outcomes in PDDL: STRIPS with types and action costs. Every
/// concept that actions of the model change is a type, each symbol of it an object, and
/// `(target_color color-3)` says which one the target has. What was compiled stands in facts of the
/// problem, each over as few concepts as determine it: `valid` for states, for each action
/// `legal_`, `leads_` for the symbols that it leads to and `cost_`. docs/exports.md explains it by
/// an example.
///
/// A plan is allowed by the text exactly if `replay` finds no fault in it, with one exception:
/// actions that change nothing in any state are left out. Equal graphs and options give equal
/// bytes. Source: M. Fox and D. Long, PDDL2.1, 2003, doi:10.1613/jair.1129, with action costs of
/// IPC 2008.
/// @throws std::invalid_argument if the determinisation is out of range.
PddlText toPddl(const SymbolGraph& graph, const PddlOptions& options = {});

/// The problem with all outcomes in PPDDL 1.0, to be solved for the greatest probability of the
/// goal: each concept changes by a probabilistic effect under conditions on as few concepts as
/// determine it, independently of the others, as in the learned model. From a state that is not
/// valid no action leads on; the start always counts as valid. Probabilities are whole billionths.
/// Of the determinisation only the legality threshold matters.
/// Source: H. L. S. Younes and M. L. Littman, PPDDL 1.0, CMU-CS-04-167, 2004.
/// @throws std::invalid_argument if the determinisation is out of range.
PddlText toPpddl(const SymbolGraph& graph, const PddlOptions& options = {});

}  // namespace conceptplan
