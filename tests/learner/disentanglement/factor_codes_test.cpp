#include "conceptplan/learner/disentanglement/factor_codes.hpp"

#include <gmock/gmock.h>

#include "learner/disentanglement/factor_grid.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(FactorCodes, ThePrincipalCodeOfALineIsThePlaceOnIt) {
  FactorCodes data = testing::perfectCodes();
  data.token = {0, 1, 0};
  data.codes.col(2) = -2 * data.codes.col(0);
  const Eigen::MatrixXd codes = principalCodes(data);
  ASSERT_EQ(codes.cols(), 2);
  EXPECT_EQ(codes.col(1), data.codes.col(1));  // a token of one dimension stays as it is
  const Eigen::VectorXd centred = data.codes.col(2).array() - data.codes.col(2).mean();
  EXPECT_TRUE(codes.col(0).isApprox(centred * std::sqrt(5.0) / 2, 1e-9));
}

TEST(FactorCodes, WithoutTokensEachDimensionStandsForItself) {
  EXPECT_EQ(principalCodes(testing::perfectCodes()), testing::perfectCodes().codes);
  EXPECT_EQ(testing::perfectCodes().numTokens(), 3);
  EXPECT_EQ(testing::perfectCodes().numValues(2), 5);
}

TEST(FactorCodes, NamesWhatDoesNotFit) {
  const auto expect = [](const FactorCodes& data, const char* message) {
    EXPECT_THAT([&] { checkFactorCodes(data); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  };
  FactorCodes data = testing::perfectCodes();
  data.codes.conservativeResize(7, 3);
  expect(data, "7 rows of codes for 2400 of factors");
  data = testing::perfectCodes();
  data.token = {0, 2, 0};
  expect(data, "token 1 has no dimension");
  data.token = {0, 1};
  expect(data, "2 tokens named for 3 dimensions");
  data.token = {0, 1, -1};
  expect(data, "a negative token");
  data.token = {0, 0, 0};
  expect(data, "at least two tokens");
  data = testing::perfectCodes();
  data.factors.col(1).setConstant(2);
  expect(data, "factor 1 has values from 2 to 2");
  data = testing::perfectCodes();
  data.codes(5, 1) = std::nan("");
  expect(data, "a code is not finite");
}

}  // namespace
}  // namespace conceptplan
