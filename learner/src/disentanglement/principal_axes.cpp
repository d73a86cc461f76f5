#include "conceptplan/learner/disentanglement/principal_axes.hpp"

#include <Eigen/Eigenvalues>

namespace conceptplan {

Eigen::MatrixXd principalAxes(Eigen::MatrixXd points, Eigen::Index count) {
  points.rowwise() -= points.colwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(points.transpose() * points);
  Eigen::MatrixXd axes = solver.eigenvectors().rightCols(count).rowwise().reverse();
  for (Eigen::Index c = 0; c < count; ++c) {  // the sign of an eigenvector is no fact: fix it
    Eigen::Index largest = 0;
    axes.col(c).cwiseAbs().maxCoeff(&largest);
    if (axes(largest, c) < 0) axes.col(c) *= -1;
  }
  return axes;
}

}  // namespace conceptplan
