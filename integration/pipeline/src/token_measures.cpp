#include "token_measures.hpp"

namespace conceptplan {

DisentanglementScores tokenScores(const std::vector<Tokens>& tokens,
                                  const std::vector<ConceptValues>& values, std::uint64_t seed) {
  const auto count = static_cast<Eigen::Index>(tokens.size());
  FactorCodes data{Eigen::MatrixXd(count, Tokens::SizeAtCompileTime),
                   Eigen::MatrixXi(static_cast<Eigen::Index>(values.size()), kNumConcepts),
                   {}};
  for (Eigen::Index i = 0; i < count; ++i)
    data.codes.row(i) =
        tokens[static_cast<std::size_t>(i)].reshaped<Eigen::RowMajor>().cast<double>();
  for (Eigen::Index i = 0; i < data.factors.rows(); ++i)
    for (std::size_t k = 0; k < kNumConcepts; ++k)
      data.factors(i, static_cast<Eigen::Index>(k)) = values[static_cast<std::size_t>(i)][k];
  for (int token = 0; token < Tokens::RowsAtCompileTime; ++token)
    data.token.insert(data.token.end(), Tokens::ColsAtCompileTime, token);
  return disentanglementScores(data, seed);
}

void addTokenScores(const DisentanglementScores& scores, const std::string& split,
                    std::map<std::string, double>& measures) {
  measures[split + "/dci"] = scores.dci.disentanglement;
  measures[split + "/dci_completeness"] = scores.dci.completeness;
  measures[split + "/dci_informativeness"] = scores.dci.informativeness;
  measures[split + "/mig"] = scores.mig;
  measures[split + "/sap"] = scores.sap;
  measures[split + "/factor_vae"] = scores.factor_vae;
  measures[split + "/beta_vae"] = scores.beta_vae;
}

}  // namespace conceptplan
