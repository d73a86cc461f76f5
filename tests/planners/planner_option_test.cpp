#include "conceptplan/planners/planner_option.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<PlannerOption> kOptions{
    {"discount", OptionType::kNumber, "0.5", 0, 1, {}, "a number"},
    {"width", OptionType::kInteger, "8", 1, 100, {}, "an integer"},
    {"symbols", OptionType::kChoice, "soft", 0, 0, {"soft", "hard"}, "a choice"}};

std::vector<std::string> faultsOf(const OptionTexts& texts) {
  std::vector<std::string> faults;
  try {
    const OptionValues values(kOptions, texts, "s.yaml");
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) faults.push_back(fault.text());
  }
  return faults;
}

TEST(OptionValues, WithoutTextsAreTheStandardOnes) {
  const OptionValues values(kOptions, {}, "");
  EXPECT_DOUBLE_EQ(values.number("discount"), 0.5);
  EXPECT_DOUBLE_EQ(values.number("width"), 8);
  EXPECT_EQ(values.choice("symbols"), "soft");
}

TEST(OptionValues, ReadTexts) {
  const OptionValues values(kOptions, {{"discount", "1e-3"}, {"symbols", "hard"}}, "");
  EXPECT_DOUBLE_EQ(values.number("discount"), 1e-3);
  EXPECT_EQ(values.choice("symbols"), "hard");
}

TEST(OptionValues, TellAllFaultsAtOnce) {
  EXPECT_THAT(
      faultsOf({{"discuont", "1"}, {"discount", "2"}, {"width", "2.5"}, {"symbols", "mild"}}),
      ElementsAre(HasSubstr("s.yaml: planner.options.discuont: unknown option; did you mean "
                            "\"discount\"?"),
                  HasSubstr("planner.options.discount: expected a number in [0, 1], found \"2\""),
                  HasSubstr("planner.options.width: expected an integer in [1, 100], found "
                            "\"2.5\""),
                  HasSubstr("planner.options.symbols: expected one of soft | hard, found "
                            "\"mild\"")));
}

TEST(OptionValues, RefuseNumbersWithRemains) {
  EXPECT_THAT(faultsOf({{"discount", "0.5x"}}), ::testing::SizeIs(1));
  EXPECT_THAT(faultsOf({{"discount", "nan"}}), ::testing::SizeIs(1));
  EXPECT_THAT(faultsOf({{"discount", ""}}), ::testing::SizeIs(1));
}

TEST(OptionValues, AskedForAnUnknownNameThrow) {
  const OptionValues values(kOptions, {}, "");
  EXPECT_THROW(values.number("symbols"), std::invalid_argument);
  EXPECT_THROW(values.choice("width"), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
