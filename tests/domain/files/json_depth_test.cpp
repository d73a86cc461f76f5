#include "conceptplan/domain/files/json_depth.hpp"

#include <gtest/gtest.h>

#include <string>

namespace conceptplan {
namespace {

TEST(JsonDepth, CountsListsAndObjectsOutsideOfStrings) {
  const std::string open(kMostJsonLevels, '['), close(kMostJsonLevels, ']');
  EXPECT_FALSE(nestsTooDeep(open + close));
  EXPECT_TRUE(nestsTooDeep(open + "{}" + close));
  EXPECT_FALSE(nestsTooDeep("{\"a\": \"" + open + open + "\"}"));
  EXPECT_FALSE(nestsTooDeep("[\"\\\"" + open + open + "\"]"));
  std::string wide = "[";
  for (int i = 0; i < 1000; ++i) wide += "[],{},";
  EXPECT_FALSE(nestsTooDeep(wide + "0]"));
  EXPECT_FALSE(nestsTooDeep(""));
}

}  // namespace
}  // namespace conceptplan
