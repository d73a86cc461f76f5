#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/symbols.hpp"

namespace conceptplan {

/// What is given of one concept of one object by hand: its symbol, or the probability of each.
using GivenSymbol = std::variant<SymbolId, std::vector<double>>;
using GivenSymbols = std::array<GivenSymbol, kNumConcepts>;

/// A task shown in two pictures of 384 x 256 with the same instance ids.
struct PictureInput {
  RgbdImage initial;
  RgbdImage goal;
};

/// A task told in symbols of the model. Object i has the instance id i + 1.
struct SymbolInput {
  std::vector<GivenSymbols> objects;     ///< at least one
  GivenSymbols goal;                     ///< what the target should become; not read for several
  std::vector<GivenSymbols> goals = {};  ///< of each of the scenario's `targets`; else empty
};

struct PlannerChoice {
  std::string name = "belief";
  std::map<std::string, std::string> options;  ///< as written; the planner's registry checks them
  int top = 5;                                 ///< number of plans wanted, in [1, 1000]
};

/// How the best plan becomes a smooth motion.
struct RefinementChoice {
  double clearance_m = 0;  ///< to keep to every object and to the workbench's edge, in [0, 1]
  /// As written; whoever knows the refiner checks it. Nothing: the refiner's own.
  std::optional<std::string> algorithm = {};
  std::optional<int> max_evaluations = {};  ///< in [1, 1e6]; nothing: the refiner's own
  bool operator==(const RefinementChoice&) const = default;
};

/// Where something stands in a file, from 1.
struct TextPosition {
  int line = 0;
  int column = 0;
};

/// One task for the whole route from input to plan, as written in a scenario folder.
struct Scenario {
  std::string name;
  std::filesystem::path file;     ///< the scenario.yaml; empty if made by a program
  std::string model = "default";  ///< a shipped model's name, or a folder
  std::variant<PictureInput, SymbolInput> input;
  std::optional<std::uint8_t> target;  ///< instance id; nothing: the one whose symbols differ
  /// Instance ids, each once, of several objects to be moved; empty: `target` alone.
  std::vector<std::uint8_t> targets;
  PlannerChoice planner;
  std::optional<RefinementChoice> refine;  ///< nothing: no refinement wanted
  bool render = true;
  std::optional<std::filesystem::path> reference;  ///< ground truth; planners never see it

  /// Position of each key in the file, e.g. "planner.options.legality_threshold".
  std::map<std::string, TextPosition> positions;

  /// A fault of this scenario at a key, with its line if it came from a file.
  Fault fault(const std::string& key, const std::string& message) const;
};

/// The planner's problem of a scenario told in symbols, on the standard workbench.
/// @param cardinality number of symbols of each concept in the model
/// @throws InputError with ALL symbols that the model does not have, and for several targets.
/// @throws std::invalid_argument if the scenario is told in pictures.
SymbolicProblem problemOf(const Scenario& scenario,
                          const std::array<std::size_t, kNumConcepts>& cardinality);

/// The same of a scenario with several targets; reasons call them "object ID".
/// @throws InputError with ALL symbols that the model does not have.
/// @throws std::invalid_argument if the scenario is told in pictures, or has no `targets`.
JointProblem jointProblemOf(const Scenario& scenario,
                            const std::array<std::size_t, kNumConcepts>& cardinality);

}  // namespace conceptplan
