#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/domain/symbols.hpp"
#include "conceptplan/planners/plan_result.hpp"

namespace conceptplan {

/// The pictures after one action of the best plan. A picture of width 0 is left out; of those that
/// are shown only the colours are read.
struct ReportFrames {
  RgbdImage predicted;  ///< what the learned transition model renders
  RgbdImage reference;  ///< what the simulator renders, where there is a ground truth
};

/// The continuous motion that the best plan was refined to.
struct ReportMotion {
  std::vector<Eigen::Vector3d> points;  ///< x, y and lift in the workbench's frame, metres
  double length_m = 0;
  double clearance_m = 0;
  std::string fallback;  ///< why it is the plan as it was; empty if it was refined
};

/// All that one page tells of one scenario, solved or not. Text is UTF-8 and escaped by the page;
/// what is empty is left out.
struct Report {
  std::string title;    ///< the scenario's name
  std::string verdict;  ///< one sentence more, e.g. whether the simulator confirms the plan
  RgbdImage initial;    ///< with its mask; width 0 if the task was told in symbols
  RgbdImage goal;
  SymbolicProblem problem;              ///< what was read of the pictures
  std::vector<TargetGoal> targets;      ///< all of several; empty: the problem's one
  std::vector<std::uint8_t> instances;  ///< mask id of each object of the problem; empty: 1, 2, ...
  SymbolGrounding grounding;            ///< names and places of the symbols
  std::vector<std::string> doubts;      ///< sentences on symbols that are guesses
  PlanResult result;
  std::vector<ReportFrames> frames;  ///< one an action of the best plan, or none
  std::optional<ReportMotion> motion;
  /// An action was legal where its probability was greater; nothing if that is not known.
  std::optional<double> legality_threshold;
  std::vector<std::pair<std::string, double>> times_ms;       ///< name, duration
  std::vector<std::pair<std::string, std::string>> facts;     ///< e.g. planner, seed, model
  std::vector<std::pair<std::string, std::string>> versions;  ///< of the program and libraries
};

/// One self-contained HTML page: no script, no network, pictures as data: URIs. Equal reports give
/// equal pages.
/// @throws std::invalid_argument if a target, a moved object, the object of a rejection or one
///   that blocks the way is not among the objects, what is nearest is told of other than all
///   targets, the best plan has other than one predicted state and, if any, one pair of frames an
///   action, a plan for several targets has other than one moved
///   object an action, or a picture's channels do not fit its size.
std::string renderReport(const Report& report);

/// Writes the page atomically. @throws as `renderReport` and `writeFileAtomically`.
void writeReport(const std::filesystem::path& path, const Report& report);

}  // namespace conceptplan
