#include "conceptplan/domain/input_error.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

TEST(Fault, TextNamesWhatIsKnown) {
  EXPECT_EQ((Fault{"a.yaml", 3, 7, "initial.rgb", "is missing"}.text()),
            "a.yaml:3:7: initial.rgb: is missing");
  EXPECT_EQ((Fault{"a.yaml", 3, {}, "", "is malformed"}.text()), "a.yaml:3: is malformed");
  EXPECT_EQ((Fault{"a.png", {}, {}, "", "is missing"}.text()), "a.png: is missing");
  EXPECT_EQ((Fault{"", {}, {}, "--level", "is too high"}.text()), "--level: is too high");
  EXPECT_EQ((Fault{"a.yaml", {}, 7, "key", "m"}.text()), "a.yaml: key: m");
}

TEST(InputError, TellsAllFaultsAtOnce) {
  const InputError error({{"a", 1, {}, "", "first"}, {"b", 2, {}, "", "second"}});
  EXPECT_EQ(error.faults().size(), 2u);
  EXPECT_STREQ(error.what(), "a:1: first\nb:2: second");
}

}  // namespace
}  // namespace conceptplan
