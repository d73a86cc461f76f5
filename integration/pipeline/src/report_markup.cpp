#include "report_markup.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "conceptplan/domain/files/rgbd_image_file.hpp"

namespace conceptplan::report {
namespace {

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8 | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += j <= count ? kDigits[group >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string decimal(double value, int decimals) {
  if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : value > 0 ? "∞" : "−∞";
  std::array<char, 400> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, decimals);
  return {digits.data(), end.ptr};
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

std::string attribute(std::string_view name, double value) {
  return attribute(name, decimal(value, 1));
}

std::string percent(double share) {
  if (share > 0 && share < 0.0005) return "&lt; 0.1&nbsp;%";
  return decimal(100 * share, 1) + "&nbsp;%";
}

std::string sentence(std::string_view text) {
  if (text.empty()) return {};
  std::string full(text);
  if (full.front() >= 'a' && full.front() <= 'z') full.front() += 'A' - 'a';
  if (full.back() != '.') full += '.';
  return escaped(full);
}

std::string bar(double share) {
  const double width = std::isfinite(share) ? std::clamp(100 * share, 0.0, 100.0) : 0.0;
  return "<span class=\"bar\" aria-hidden=\"true\"><span style=\"width:" + decimal(width, 1) +
         "%\"></span></span>";
}

std::string dataUri(int width, int height, std::span<const std::uint8_t> rgb) {
  return "data:image/png;base64," + base64(encodePng(width, height, rgb));
}

std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string text;
  for (;;) {
    const std::size_t open = page.find("{{");
    text += page.substr(0, open);
    if (open == std::string_view::npos) return text;
    const std::size_t close = page.find("}}", open);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    const auto value = std::find_if(values.begin(), values.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    if (close == std::string_view::npos || value == values.end()) {
      throw std::invalid_argument("no value for '" + std::string(name) + "' of the page");
    }
    text += value->second;
    page.remove_prefix(close + 2);
  }
}

}  // namespace conceptplan::report
