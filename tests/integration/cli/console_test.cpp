#include "console.hpp"

#include <gtest/gtest.h>

namespace conceptplan::cli {
namespace {

TEST(Console, DurationsReadNaturally) {
  EXPECT_EQ(durationText(0.2), "0 s");
  EXPECT_EQ(durationText(59.4), "59 s");
  EXPECT_EQ(durationText(65), "1 min 05 s");
  EXPECT_EQ(durationText(3900), "1 h 05 min");
  EXPECT_EQ(durationText(-3), "0 s");
}

TEST(Console, DecimalsHaveAPoint) {
  EXPECT_EQ(decimal(2.0 / 3, 3), "0.667");
  EXPECT_EQ(decimal(-1, 0), "-1");
}

TEST(Console, JsonSilencesTextAndTextSilencesJson) {
  testing::internal::CaptureStdout();
  Console with_json(true, false);
  with_json.print("text");
  with_json.printJson({{"a", 1}});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "{\n  \"a\": 1\n}\n");
  testing::internal::CaptureStdout();
  Console with_text(false, false);
  with_text.printJson({{"a", 1}});
  with_text.print(TextTable{{"é", "b"}, {"ccc", "d"}});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "é    b\nccc  d\n");
}

TEST(Console, QuietKeepsErrors) {
  testing::internal::CaptureStderr();
  Console console(false, true);
  console.message("note");
  console.progress("work")(1, 2);
  console.error("wrong");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "wrong\n");
}

}  // namespace
}  // namespace conceptplan::cli
