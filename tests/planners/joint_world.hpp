#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan::testing {

/// A joint problem with its model.
struct JointWorld {
  SymbolicModel model;
  JointProblem problem;
};

/// A thing in a column, a row and a quarter turn.
struct Placement {
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t rotation = 0;
};

/// Targets on a bench of sure moves and turns, each with where it starts and where it should end;
/// then obstacles.
JointWorld jointGrid(int columns, int rows, int rotations,
                     const std::vector<std::pair<Placement, Placement>>& targets,
                     const std::vector<Placement>& obstacles = {});

/// A bench of that size with as many targets and obstacles, all drawn. No two stand in one cell;
/// goals may be out of reach.
JointWorld drawnJointGrid(int columns, int rows, int rotations, std::size_t targets,
                          std::size_t obstacles, std::uint64_t seed);

/// Two targets of `randomModel`, whose actions have uncertain outcomes, on 3 x 2 cells.
JointWorld randomJointWorld(std::uint64_t seed);

/// A thing and a dyer on 3 x 2 cells, both targets. Things of type 1 are dyers: change_color is
/// legal beside the nearest one, and takes its colour of two. Starts and goals are drawn; a second
/// dyer that stands still may give the first one its colour.
JointWorld dyerWorld(std::uint64_t seed);

/// A task of one or several targets, with the learned model.
JointWorld learnedJointWorld(const Task& task);

/// The least cost, in nats, of a joint plan of at most `most_steps` actions, and the fewest actions
/// at this cost; nothing if there is none.
struct LeastCost {
  double cost = 0;
  std::size_t steps = 0;
};

/// By dynamic programming over the symbols of all objects and the number of steps, with the model
/// asked anew for every step: what a joint planner is held to. A step costs
/// `-log Pr[outcome] - log(1 - step_discount)`, or 1 if actions are counted.
std::optional<LeastCost> leastJointCost(const JointWorld& world, std::size_t most_steps,
                                        double legality_threshold, double step_discount,
                                        bool count_actions = false);

/// The least cost of each way to the goal of at most `most_steps` actions, by rising cost; ways in
/// which each target has the same actions are one. By trying every sequence.
std::vector<double> allJointCosts(const JointWorld& world, std::size_t most_steps,
                                  double legality_threshold, double step_discount);

}  // namespace conceptplan::testing
