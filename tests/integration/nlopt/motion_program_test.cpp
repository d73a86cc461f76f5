#include "motion_program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "integration/nlopt/motion_worlds.hpp"

namespace conceptplan {
namespace {

double draw(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Of a level-4 plan of many actions.
MotionTask longMotion() {
  for (int i = 0;; ++i) {
    MotionTask task = testing::plannedMotion(4, i);
    if (task.waypoints.size() > 8) return task;
  }
}

std::vector<bool> allLifted(const MotionTask& task) {
  return std::vector<bool>(task.waypoints.size() - 1, true);
}

/// Pushed or lifted, with all its constraints.
MotionProgram programOf(const MotionTask& task, bool lifted) {
  const Trajectory discrete = discreteTrajectory(task, 1);
  MotionProgram program(task, {}, discrete, lifted ? allLifted(task) : std::vector<bool>());
  program.select(discrete, 1);
  return program;
}

/// Variables within the bounds.
Eigen::VectorXd somewhere(const MotionProgram& program, std::mt19937_64& random) {
  Eigen::VectorXd variables(program.numVariables());
  for (Eigen::Index i = 0; i < variables.size(); ++i) {
    variables[i] = draw(random, program.lowerBounds()[i], program.upperBounds()[i]);
  }
  return variables;
}

class MotionProgramGradient : public ::testing::TestWithParam<bool> {
 protected:
  MotionTask task_ = longMotion();
  MotionProgram program_ = programOf(task_, GetParam());
  std::mt19937_64 random_{5};
};

TEST_P(MotionProgramGradient, OfTheObjectiveIsThatOfFiniteDifferences) {
  constexpr double kStep = 1e-6;
  ASSERT_GT(program_.numVariables(), 10);
  for (int trial = 0; trial < 3; ++trial) {
    Eigen::VectorXd variables = somewhere(program_, random_);
    Eigen::VectorXd gradient(program_.numVariables());
    const double value = program_.objective(variables, gradient.data());
    EXPECT_EQ(value, program_.objective(variables, nullptr));
    for (Eigen::Index i = 0; i < variables.size(); ++i) {
      const double at = variables[i];
      variables[i] = at + kStep;
      const double above = program_.objective(variables, nullptr);
      variables[i] = at - kStep;
      const double below = program_.objective(variables, nullptr);
      variables[i] = at;
      const double difference = (above - below) / (2 * kStep);
      EXPECT_NEAR(gradient[i], difference, 1e-5 * (1 + std::abs(difference))) << i;
    }
  }
}

TEST_P(MotionProgramGradient, OfTheConstraintsIsThatOfFiniteDifferences) {
  constexpr double kStep = 1e-7;
  const auto count = static_cast<Eigen::Index>(program_.numConstraints());
  ASSERT_GT(count, 50);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  for (int trial = 0; trial < 3; ++trial) {
    Eigen::VectorXd variables = somewhere(program_, random_);
    Eigen::VectorXd values(count), above(count), below(count);
    Rows gradients(count, program_.numVariables());
    program_.constraints(variables, values.data(), gradients.data());
    for (Eigen::Index i = 0; i < variables.size(); ++i) {
      const double at = variables[i];
      variables[i] = at + kStep;
      program_.constraints(variables, above.data(), nullptr);
      variables[i] = at - kStep;
      program_.constraints(variables, below.data(), nullptr);
      variables[i] = at;
      const Eigen::VectorXd difference = (above - below) / (2 * kStep);
      EXPECT_LT((gradients.col(i) - difference).cwiseAbs().maxCoeff(), 1e-4) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PushedAndLifted, MotionProgramGradient, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "Lifted" : "Pushed"; });

TEST(MotionProgram, VariablesAndTrajectoriesAreOneAnother) {
  std::mt19937_64 random(7);
  const MotionTask task = longMotion();
  for (const bool lifted : {false, true}) {
    const MotionProgram program = programOf(task, lifted);
    const Trajectory discrete = discreteTrajectory(task, 1);
    if (!lifted) {
      EXPECT_EQ(program.trajectoryOf(program.startOf(discrete)), discrete);
    }
    const Eigen::VectorXd variables = somewhere(program, random);
    const Trajectory motion = program.trajectoryOf(variables);
    EXPECT_EQ(motion.at(0), discrete.at(0));
    EXPECT_EQ(motion.at(1e9), discrete.at(1e9));
    EXPECT_TRUE(motion.controlPoints().row(2) == discrete.controlPoints().row(2));
    EXPECT_EQ(motion.controlPoints().row(3).maxCoeff() > 0, lifted);
  }
}

TEST(MotionProgram, TheObjectiveIsLengthAndWeightedJerk) {
  std::mt19937_64 random(9);
  const MotionTask task = longMotion();
  RefinementOptions options;
  options.jerk_weight = 0.002;
  const Trajectory discrete = discreteTrajectory(task, 1);
  const MotionProgram program(task, options, discrete, {});
  const Trajectory motion = program.trajectoryOf(somewhere(program, random));
  const double expected = length_m(motion) + 0.002 * squaredJerk(motion);
  // Chords of a quarter span are a little shorter than the way.
  EXPECT_NEAR(program.objective(program.startOf(motion), nullptr), expected, 0.02 * expected);
}

}  // namespace
}  // namespace conceptplan
