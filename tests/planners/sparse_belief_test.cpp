#include "sparse_belief.hpp"

#include <gmock/gmock.h>

#include "planners/random_world.hpp"

namespace conceptplan {
namespace {

constexpr double kThreshold = 0.01;
constexpr std::uint64_t kWorlds = 20;

TEST(SparseBelief, TheStatesOfABeliefAreThoseOfTheWholeVector) {
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = testing::randomWorld(seed, seed % 2 == 0);
    const SymbolBelief& belief = graph.problem().goal;
    EXPECT_EQ(dense(sparseStateBelief(graph, belief), graph.numStates()),
              graph.stateBelief(belief));
  }
}

/// Eq. (5) of arXiv 2310.03325 as it is written, over all states.
StateBelief eq5(const SymbolGraph& graph, const StateBelief& belief, Action action) {
  StateBelief next(graph.numStates(), 0);
  for (std::size_t i = 0; i < belief.size(); ++i) {
    const auto state = static_cast<StateId>(i);
    if (graph.legality(state, action) <= kThreshold) continue;
    for (const Transition& transition : graph.transitions(state, action)) {
      next[index(transition.state)] += belief[i] * transition.probability;
    }
  }
  return next;
}

TEST(SparseBelief, Eq5IsTheSameToTheBit) {
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = testing::randomWorld(seed, true);
    const StateBelief belief = startBelief(graph, graph.initialBelief());
    for (const Action action : kActions) {
      const SparseBelief next = propagateLegal(graph, sparse(belief), action, kThreshold);
      EXPECT_EQ(dense(next, graph.numStates()), eq5(graph, belief, action));
    }
  }
}

TEST(SparseBelief, KeepsWhatItHoldsByState) {
  const SparseBelief belief = sparse({0, 0.25, 0, 0.75});
  ASSERT_EQ(belief.size(), 2u);
  EXPECT_EQ(belief[0].state, StateId{1});
  EXPECT_EQ(belief[1].mass, 0.75);
  EXPECT_EQ(agreement(belief, sparse({1, 0, 1, 0.5})), 0.375);
}

TEST(SparseBelief, NothingScaledStaysNothing) {
  SparseBelief nothing;
  EXPECT_EQ(normalize(nothing), 0);
  EXPECT_TRUE(nothing.empty());
}

}  // namespace
}  // namespace conceptplan
