#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>

namespace conceptplan::cli {

/// Refuses a value of an option that is no number in [least, most]; where the bounds are whole, it
/// must be whole.
template <typename Number>
CLI::Validator inRange(Number least, Number most) {
  std::ostringstream range;
  range << "[" << least << ", " << most << "]";
  const std::string expected =
      (std::is_integral_v<Number> ? "a whole number in " : "a number in ") + range.str();
  const auto check = [least, most, expected](const std::string& text) {
    const char* const end = text.data() + text.size();
    Number value{};
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    // Written so that nan, which compares with nothing, does not fit.
    const bool fits = error == std::errc{} && stop == end && value >= least && value <= most;
    return fits ? std::string() : "expected " + expected + ", found \"" + text + "\"";
  };
  return CLI::Validator(check, range.str());
}

}  // namespace conceptplan::cli
