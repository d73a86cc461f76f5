#include "conceptplan/learner/disentanglement/factor_codes.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "conceptplan/learner/disentanglement/principal_axes.hpp"

namespace conceptplan {
namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw std::invalid_argument("disentanglement: " + message);
}

/// The columns of the codes that belong to a token.
Eigen::MatrixXd columnsOf(const FactorCodes& data, int token) {
  Eigen::MatrixXd columns(data.codes.rows(),
                          std::count(data.token.begin(), data.token.end(), token));
  Eigen::Index next = 0;
  for (std::size_t d = 0; d < data.token.size(); ++d)
    if (data.token[d] == token) columns.col(next++) = data.codes.col(static_cast<Eigen::Index>(d));
  return columns;
}

Eigen::VectorXd firstPrincipalCoordinate(Eigen::MatrixXd points) {
  if (points.cols() == 1) return points.col(0);
  points.rowwise() -= points.colwise().mean().eval();
  return points * principalAxes(points, 1);
}

}  // namespace

Eigen::Index FactorCodes::numTokens() const {
  return token.empty() ? codes.cols() : *std::max_element(token.begin(), token.end()) + 1;
}

void checkFactorCodes(const FactorCodes& data) {
  if (data.codes.rows() < 10 || data.codes.rows() != data.factors.rows())
    refuse(std::to_string(data.codes.rows()) + " rows of codes for " +
           std::to_string(data.factors.rows()) + " of factors; expected as many, at least 10");
  if (!data.token.empty()) {
    if (data.token.size() != static_cast<std::size_t>(data.codes.cols()))
      refuse(std::to_string(data.token.size()) + " tokens named for " +
             std::to_string(data.codes.cols()) + " dimensions");
    for (int token = 0; token < static_cast<int>(data.numTokens()); ++token)
      if (std::find(data.token.begin(), data.token.end(), token) == data.token.end())
        refuse("token " + std::to_string(token) + " has no dimension");
    if (*std::min_element(data.token.begin(), data.token.end()) < 0) refuse("a negative token");
  }
  if (data.codes.cols() < 1 || data.numTokens() < 2 || data.factors.cols() < 2)
    refuse("expected at least two tokens and two factors, found " +
           std::to_string(data.codes.cols()) + " dimensions and " +
           std::to_string(data.factors.cols()) + " factors");
  if (!data.codes.allFinite()) refuse("a code is not finite");
  for (Eigen::Index k = 0; k < data.factors.cols(); ++k) {
    const auto values = data.factors.col(k);
    if (values.minCoeff() < 0 || values.minCoeff() == values.maxCoeff())
      refuse("factor " + std::to_string(k) + " has values from " +
             std::to_string(values.minCoeff()) + " to " + std::to_string(values.maxCoeff()) +
             "; expected at least two, from 0");
  }
}

Eigen::MatrixXd principalCodes(const FactorCodes& data) {
  if (data.token.empty()) return data.codes;
  Eigen::MatrixXd codes(data.codes.rows(), data.numTokens());
  for (Eigen::Index token = 0; token < codes.cols(); ++token)
    codes.col(token) = firstPrincipalCoordinate(columnsOf(data, static_cast<int>(token)));
  return codes;
}

}  // namespace conceptplan
