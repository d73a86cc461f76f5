#pragma once

#include <ompl/base/StateSpace.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// Whether the target can move from one valid state to another, by the symbols of both. Threads
/// call it at the same time.
using MotionCheck = std::function<bool(const Symbols& from, const Symbols& to)>;

/// A symbol graph as a discrete state space of OMPL. Its states are those of reading 0: what is
/// believed of the other objects is no state that an action reaches.
///
/// The distance is learned: for each concept the fewest most probable steps between two symbols,
/// whatever the other concepts are, summed over the concepts. Where no steps join two symbols it is
/// the number of symbols. It is a metric. Interpolation snaps to the nearer end.
class SymbolStateSpace final : public ompl::base::StateSpace {
 public:
  class StateType final : public ompl::base::State {
   public:
    StateType() = default;
    explicit StateType(StateId state) : id(state) {}

    StateId id{};
  };

  /// Where an action leads that is not legal, or whose motion is denied: out of bounds, never
  /// valid.
  static constexpr StateId kNowhere{-1};

  /// @param check_motion null: every motion passes
  /// @throws std::invalid_argument if the graph is null or the threshold is not in [0, 1].
  explicit SymbolStateSpace(std::shared_ptr<const SymbolGraph> graph,
                            double legality_threshold = 0.01, MotionCheck check_motion = nullptr);

  const SymbolGraph& graph() const { return *graph_; }
  std::size_t numStates() const { return graph_->numStates() / graph_->numReadings(); }
  static StateId id(const ompl::base::State* state) { return state->as<StateType>()->id; }
  bool contains(StateId state) const { return index(state) < numStates(); }

  /// The most probable outcome of the action, valid or not; kNowhere where the action is not legal
  /// or the check denies the motion to that outcome. Out of a start that is not valid itself, where
  /// the target stands all the same, motions are not asked for.
  StateId next(StateId state, Action action) const;

  /// The concepts that actions change: the axes of the default projection.
  const std::vector<Concept>& axes() const { return axes_; }
  std::size_t numSymbols(Concept which) const { return order_[index(which)].size(); }
  /// Place of a state's symbol on an axis, in [0, numSymbols); steps away from one end of the axis
  /// count up.
  std::size_t place(StateId state, Concept axis) const;
  /// The symbol at a place of an axis.
  SymbolId symbolAt(Concept axis, std::size_t place) const { return order_[index(axis)][place]; }
  /// Fewest most probable steps between two symbols of a concept.
  double steps(Concept which, SymbolId from, SymbolId to) const;

  /// Samplers made from now on draw from this seed, not from OMPL's generator of the process.
  void seedSamplers(std::uint64_t seed);

  bool isDiscrete() const override { return true; }
  unsigned int getDimension() const override;
  double getMaximumExtent() const override { return maximum_extent_; }
  double getMeasure() const override { return static_cast<double>(numStates()); }
  void enforceBounds(ompl::base::State* state) const override;
  bool satisfiesBounds(const ompl::base::State* state) const override;
  void copyState(ompl::base::State* destination, const ompl::base::State* source) const override;
  double distance(const ompl::base::State* first, const ompl::base::State* second) const override;
  bool equalStates(const ompl::base::State* first, const ompl::base::State* second) const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  unsigned int getSerializationLength() const override { return sizeof(StateId); }
  void serialize(void* serialization, const ompl::base::State* state) const override;
  void deserialize(ompl::base::State* state, const void* serialization) const override;
  ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;
  ompl::base::State* allocState() const override { return new StateType; }
  void freeState(ompl::base::State* state) const override { delete state->as<StateType>(); }
  void printState(const ompl::base::State* state, std::ostream& out) const override;
  void registerProjections() override;

 private:
  void measureSteps();
  void orderSymbols(Concept axis);

  std::shared_ptr<const SymbolGraph> graph_;
  double legality_threshold_;
  MotionCheck check_motion_;
  std::vector<Concept> axes_;
  std::array<std::vector<double>, kNumConcepts> steps_;       // [symbols * symbols]
  std::array<std::vector<SymbolId>, kNumConcepts> order_;     // symbol at each place
  std::array<std::vector<std::size_t>, kNumConcepts> place_;  // place of each symbol
  double maximum_extent_ = 0;
};

}  // namespace conceptplan
