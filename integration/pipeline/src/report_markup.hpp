#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace conceptplan::report {

/// Text as HTML: `& < > " '` become entities, also safe in a quoted attribute.
std::string escaped(std::string_view text);

/// Fixed decimals, always with a point. "not a number" and infinities read so.
std::string decimal(double value, int decimals);

/// ` name="value"`; the value is escaped.
std::string attribute(std::string_view name, std::string_view value);
/// The same with one decimal.
std::string attribute(std::string_view name, double value);

/// A share as "87.4 %"; what is above 0 but rounds to it reads "< 0.1 %".
std::string percent(double share);

/// Text that begins with a capital letter and ends with a full stop; escaped. Empty stays empty.
std::string sentence(std::string_view text);

/// A bar filled to a share in [0, 1]; decoration beside a number, hidden from screen readers.
std::string bar(double share);

/// "data:image/png;base64,..." of an [height, width, 3] picture.
std::string dataUri(int width, int height, std::span<const std::uint8_t> rgb);

/// The template with each `{{name}}` replaced by its value; values are not searched again.
/// @throws std::invalid_argument for a name that has no value.
std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string_view, std::string>>& values);

}  // namespace conceptplan::report
