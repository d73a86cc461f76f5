#include "planners/learned_world.hpp"

#include <numeric>
#include <random>

#include "conceptplan/domain/simulation/simulator.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"

namespace conceptplan::testing {
namespace {

constexpr int kDyer = static_cast<int>(ObjectType::kDyer);

/// A number in [0, count).
std::size_t draw(std::mt19937_64& random, std::size_t count) { return random() % count; }

double drawShare(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

int seenType(ObjectType type) {
  const auto value = static_cast<int>(type);
  return value < static_cast<int>(kNumSeenTypes) ? value : value % kDyer;
}

Symbols misreadSome(Symbols symbols, double misread, std::mt19937_64& random) {
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    if (drawShare(random) >= misread) continue;
    const std::size_t shift = 1 + draw(random, kConceptCardinality[k] - 1);
    symbols[k] = static_cast<SymbolId>((index(symbols[k]) + shift) % kConceptCardinality[k]);
  }
  return symbols;
}

}  // namespace

Relabelling::Relabelling(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    for (std::size_t i = 0; i < kConceptCardinality[k]; ++i) {
      symbol_of_[k].push_back(static_cast<SymbolId>(i));
    }
    for (std::size_t i = symbol_of_[k].size(); seed != 0 && i > 1; --i) {
      std::swap(symbol_of_[k][i - 1], symbol_of_[k][draw(random, i)]);
    }
  }
}

SymbolId Relabelling::symbol(Concept which, int value) const {
  return symbol_of_[index(which)][static_cast<std::size_t>(value)];
}

Symbols Relabelling::symbols(const ObjectState& object) const {
  return {
      symbol(Concept::kType, seenType(object.type)), symbol(Concept::kPositionX, object.cell.x),
      symbol(Concept::kPositionY, object.cell.y),    symbol(Concept::kRotation, object.rotation),
      symbol(Concept::kColor, object.color),         symbol(Concept::kSize, object.size)};
}

SymbolGrounding Relabelling::grounding() const {
  const SymbolGrounding standard = standardGrounding();
  SymbolGrounding grounding = standard;
  const auto at = [&](Concept which, std::size_t value) {
    return index(symbol_of_[index(which)][value]);
  };
  for (const Concept which : kConcepts) {
    for (std::size_t value = 0; value < kConceptCardinality[index(which)]; ++value) {
      grounding.names[index(which)][at(which, value)] = standard.names[index(which)][value];
    }
  }
  for (std::size_t x = 0; x < 3; ++x) {
    grounding.columns[at(Concept::kPositionX, x)] = static_cast<int>(x);
  }
  for (std::size_t y = 0; y < 5; ++y) {
    grounding.rows[at(Concept::kPositionY, y)] = static_cast<int>(y);
  }
  for (std::size_t type = 0; type < 8; ++type) {
    for (std::size_t size = 0; size < 4; ++size) {
      for (std::size_t rotation = 0; rotation < 4; ++rotation) {
        grounding.footprints[at(Concept::kType, type)][at(Concept::kSize, size)][at(
            Concept::kRotation, rotation)] = standard.footprints[type][size][rotation];
      }
    }
  }
  return grounding;
}

SymbolicProblem Relabelling::problem(const Task& task) const {
  SymbolicProblem problem;
  problem.initial.workbench = task.initial.workbench;
  problem.initial.target = task.initial.target;
  for (const ObjectState& object : task.initial.objects) {
    problem.initial.objects.push_back(certain(symbols(object), kConceptCardinality));
  }
  problem.goal = certain(symbols(task.goal), kConceptCardinality);
  return problem;
}

std::vector<Triplet> trainingTriplets(const Relabelling& relabelling,
                                      const std::vector<int>& levels, int tasks_per_level,
                                      double misread, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Triplet> triplets;
  for (const int level : levels) {
    TaskOptions options;
    options.level = level;
    options.seed = seed;
    const TaskGenerator generator(options);
    for (int i = 0; i < tasks_per_level; ++i) {
      const Task task = generator.task(i);
      World world = task.initial;
      for (const Action action : task.reference) {
        Triplet triplet;
        for (const ObjectState& object : world.objects) {
          triplet.objects.push_back(misreadSome(relabelling.symbols(object), misread, random));
        }
        triplet.target = world.target;
        triplet.action = action;
        world = applyAction(world, action).world;
        triplet.after =
            misreadSome(relabelling.symbols(world.objects[world.target]), misread, random);
        triplets.push_back(std::move(triplet));
      }
    }
  }
  return triplets;
}

const Relabelling& learnedRelabelling() {
  static const Relabelling relabelling(20);
  return relabelling;
}

const SymbolicModel& learnedModel() {
  static const SymbolicModel model =
      estimateSymbolicModel(trainingTriplets(learnedRelabelling(), {1, 2, 3, 4}, 500, 0, 1),
                            learnedRelabelling().grounding(), kConceptCardinality);
  return model;
}

}  // namespace conceptplan::testing
