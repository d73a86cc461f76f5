#include <cmath>
#include <random>
#include <vector>

#include "conceptplan/learner/disentanglement/disentanglement_scores.hpp"

namespace conceptplan {
namespace {

constexpr int kBatch = 64;  // pictures, or pairs, of which each example is made
constexpr Eigen::Index kTrainExamples = 5000;
constexpr Eigen::Index kTestExamples = 2500;

/// Draws pictures that share the value of a factor, with replacement.
class FixedFactorSampler {
 public:
  FixedFactorSampler(const Eigen::MatrixXi& factors, std::uint64_t seed)
      : factors_(factors), generator_(seed), rows_(static_cast<std::size_t>(factors.cols())) {
    for (Eigen::Index k = 0; k < factors.cols(); ++k) {
      auto& of_value = rows_[static_cast<std::size_t>(k)];
      of_value.resize(static_cast<std::size_t>(factors.col(k).maxCoeff()) + 1);
      for (Eigen::Index i = 0; i < factors.rows(); ++i)
        of_value[static_cast<std::size_t>(factors(i, k))].push_back(i);
    }
  }

  Eigen::Index factor() { return below(factors_.cols()); }
  Eigen::Index row() { return below(factors_.rows()); }
  /// A picture with the same value of a factor as that row.
  Eigen::Index like(Eigen::Index row, Eigen::Index factor) {
    const auto& rows =
        rows_[static_cast<std::size_t>(factor)][static_cast<std::size_t>(factors_(row, factor))];
    return rows[static_cast<std::size_t>(below(static_cast<Eigen::Index>(rows.size())))];
  }

 private:
  Eigen::Index below(Eigen::Index count) {
    return static_cast<Eigen::Index>(generator_() % static_cast<std::uint64_t>(count));
  }

  const Eigen::MatrixXi& factors_;
  std::mt19937_64 generator_;
  std::vector<std::vector<std::vector<Eigen::Index>>> rows_;  // [factor][value]
};

/// Codes of mean 0 and variance 1, without those that never vary.
Eigen::MatrixXd standardized(Eigen::MatrixXd codes) {
  codes.rowwise() -= codes.colwise().mean().eval();
  Eigen::Index kept = 0;
  for (Eigen::Index d = 0; d < codes.cols(); ++d) {
    const double deviation =
        std::sqrt(codes.col(d).squaredNorm() / static_cast<double>(codes.rows()));
    if (deviation > 1e-9) codes.col(kept++) = (codes.col(d) / deviation).eval();
  }
  return codes.leftCols(kept);
}

/// Examples of pairs and the factor that each shares.
struct Examples {
  Eigen::MatrixXd features;  // [M, tokens]
  Eigen::VectorXi factors;   // [M]
};

/// How often each token varied least in pictures that share each factor: [tokens, factors].
Eigen::MatrixXi votes(const Eigen::MatrixXd& codes, FixedFactorSampler& sampler,
                      Eigen::Index factors, Eigen::Index count) {
  Eigen::MatrixXi table = Eigen::MatrixXi::Zero(codes.cols(), factors);
  Eigen::MatrixXd batch(kBatch, codes.cols());
  for (Eigen::Index example = 0; example < count; ++example) {
    const Eigen::Index factor = sampler.factor(), first = sampler.row();
    for (Eigen::Index i = 0; i < kBatch; ++i) batch.row(i) = codes.row(sampler.like(first, factor));
    batch.rowwise() -= batch.colwise().mean().eval();
    Eigen::Index least = 0;
    batch.colwise().squaredNorm().minCoeff(&least);
    ++table(least, factor);
  }
  return table;
}

/// Mean absolute differences of pairs that share a factor.
Examples pairDifferences(const Eigen::MatrixXd& codes, FixedFactorSampler& sampler,
                         Eigen::Index count) {
  Examples examples{Eigen::MatrixXd::Zero(count, codes.cols()), Eigen::VectorXi(count)};
  for (Eigen::Index example = 0; example < count; ++example) {
    const Eigen::Index factor = sampler.factor();
    examples.factors[example] = static_cast<int>(factor);
    for (int pair = 0; pair < kBatch; ++pair) {
      const Eigen::Index row = sampler.row();
      examples.features.row(example) +=
          (codes.row(row) - codes.row(sampler.like(row, factor))).cwiseAbs() / kBatch;
    }
  }
  return examples;
}

/// Probabilities of the classes, a row each.
Eigen::MatrixXd softmax(const Eigen::MatrixXd& scores) {
  Eigen::MatrixXd p = (scores.colwise() - scores.rowwise().maxCoeff()).array().exp();
  p.array().colwise() /= p.rowwise().sum().array().eval();
  return p;
}

/// Multinomial logistic regression by accelerated gradient descent: [features, classes].
Eigen::MatrixXd fitLogistic(const Eigen::MatrixXd& features, const Eigen::VectorXi& labels,
                            Eigen::Index classes) {
  constexpr int kSteps = 400;
  Eigen::MatrixXd target = Eigen::MatrixXd::Zero(features.rows(), classes);
  for (Eigen::Index i = 0; i < labels.size(); ++i) target(i, labels[i]) = 1;
  // No curvature exceeds half the mean squared norm of a row.
  const double rate = 2.0 * static_cast<double>(features.rows()) / features.squaredNorm();
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(features.cols(), classes), ahead = weights;
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::MatrixXd gradient = features.transpose() * (softmax(features * ahead) - target) /
                                     static_cast<double>(features.rows());
    const Eigen::MatrixXd next = ahead - rate * gradient;
    ahead = next + step / (step + 3.0) * (next - weights);
    weights = next;
  }
  return weights;
}

}  // namespace

double factorVaeScore(const FactorCodes& data, std::uint64_t seed) {
  checkFactorCodes(data);
  const Eigen::MatrixXd codes = standardized(principalCodes(data));
  if (codes.cols() == 0) return 1.0 / static_cast<double>(data.factors.cols());
  FixedFactorSampler sampler(data.factors, seed);
  const Eigen::Index factors = data.factors.cols();
  const Eigen::MatrixXi train = votes(codes, sampler, factors, kTrainExamples);
  const Eigen::MatrixXi test = votes(codes, sampler, factors, kTestExamples);
  double right = 0;
  for (Eigen::Index token = 0; token < codes.cols(); ++token) {
    Eigen::Index majority = 0;
    train.row(token).maxCoeff(&majority);
    right += test(token, majority);
  }
  return right / kTestExamples;
}

double betaVaeScore(const FactorCodes& data, std::uint64_t seed) {
  checkFactorCodes(data);
  FixedFactorSampler sampler(data.factors, seed);
  const Examples examples =
      pairDifferences(standardized(principalCodes(data)), sampler, kTrainExamples + kTestExamples);
  Eigen::MatrixXd features = standardized(examples.features);
  features.conservativeResize(Eigen::NoChange, features.cols() + 1);
  features.rightCols<1>().setOnes();
  const Eigen::MatrixXd weights = fitLogistic(
      features.topRows(kTrainExamples), examples.factors.head(kTrainExamples), data.factors.cols());
  const Eigen::MatrixXd scores = features.bottomRows(kTestExamples) * weights;
  double right = 0;
  for (Eigen::Index i = 0; i < kTestExamples; ++i) {
    Eigen::Index best = 0;
    scores.row(i).maxCoeff(&best);
    right += best == examples.factors[kTrainExamples + i] ? 1 : 0;
  }
  return right / kTestExamples;
}

}  // namespace conceptplan
