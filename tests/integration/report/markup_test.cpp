#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "report_markup.hpp"

namespace conceptplan::report {
namespace {

TEST(Markup, Escapes) { EXPECT_EQ(escaped("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;"); }

TEST(Markup, WritesNumbers) {
  EXPECT_EQ(decimal(1.005, 1), "1.0");
  EXPECT_EQ(decimal(-2.5, 0), "-2");
  EXPECT_EQ(decimal(std::nan(""), 1), "not a number");
  EXPECT_EQ(percent(0.8731), "87.3&nbsp;%");
  EXPECT_EQ(percent(0.0001), "&lt; 0.1&nbsp;%");
  EXPECT_EQ(percent(0), "0.0&nbsp;%");
}

TEST(Markup, KeepsBarsInTheirTrack) {
  EXPECT_NE(bar(1.5).find("width:100.0%"), std::string::npos);
  EXPECT_NE(bar(std::nan("")).find("width:0.0%"), std::string::npos);
}

TEST(Markup, EncodesAPictureOfAnyLength) {
  const std::vector<std::uint8_t> rgb{1, 2, 3};
  const std::string uri = dataUri(1, 1, rgb);
  EXPECT_EQ(uri.rfind("data:image/png;base64,iVBORw0KGgo", 0), 0U);  // the signature of a PNG
  EXPECT_EQ((uri.size() - uri.find(',') - 1) % 4, 0U);
}

TEST(Markup, FillsEachPlaceOnce) {
  EXPECT_EQ(filled("a{{x}}b{{y}}", {{"x", "{{y}}"}, {"y", "2"}}), "a{{y}}b2");
}

TEST(Markup, RefusesAPlaceWithoutAValue) {
  EXPECT_THROW(filled("{{x}}", {}), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan::report
