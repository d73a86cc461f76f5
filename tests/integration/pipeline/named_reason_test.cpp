#include "named_reason.hpp"

#include <gtest/gtest.h>

#include "conceptplan/pipeline/solve.hpp"

namespace conceptplan {
namespace {

const std::vector<std::string> kNames{"Cup 1", "Pot 4", "Egg 7"};

PlanResult blockedBy(std::vector<std::size_t> objects, const std::string& reason) {
  PlanResult result;
  result.blocking = std::move(objects);
  result.reason = reason;
  return result;
}

TEST(NamedReason, NamesWhatBlocksTheWay) {
  EXPECT_EQ(namedReason(blockedBy({1}, "none; without object 1 there would be a way; POSITION_Y"),
                        kNames),
            "none; without Pot 4 there would be a way; POSITION_Y");
  EXPECT_EQ(namedReason(blockedBy({0, 2}, "without objects 0 and 2 there would be a way"), kNames),
            "without Cup 1 and Egg 7 there would be a way");
  EXPECT_EQ(
      namedReason(blockedBy({0, 1, 2}, "without objects 0, 1 and 2 there would be a way"), kNames),
      "without Cup 1, Pot 4 and Egg 7 there would be a way");
}

TEST(NamedReason, LeavesOtherReasonsAlone) {
  EXPECT_EQ(namedReason(blockedBy({}, "COLOR must change"), kNames), "COLOR must change");
}

TEST(NamedReason, NamesWhatAReplayedStepMeets) {
  EXPECT_EQ(namedReason("its outcome meets object 2", kNames), "its outcome meets Egg 7");
  EXPECT_EQ(namedReason("its outcome meets object 3", kNames), "its outcome meets object 3");
  EXPECT_EQ(namedReason("argument 1 is a, expected b", kNames), "argument 1 is a, expected b");
}

}  // namespace
}  // namespace conceptplan
