#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace conceptplan::figures {

struct Point {
  double x = 0;
  double y = 0;
};

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  double size = 16;
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  std::string_view color = "#22262b";
};

inline constexpr std::string_view kQuiet = "#626b75";  // of texts of less weight

/// One SVG picture on white, in pixels from the top left. Marks lie over those drawn before them.
class SvgDrawing {
 public:
  /// @param title and description are for people who hear the picture.
  SvgDrawing(double width, double height, const std::string& title, const std::string& description);

  /// @param at the baseline's end that the style anchors
  void text(Point at, std::string_view content, const TextStyle& style = {});
  void line(Point from, Point to, std::string_view color, double width = 1);
  void rectangle(Point corner, double width, double height, std::string_view fill,
                 std::string_view stroke = "none");
  /// Discs of one colour.
  void dots(std::span<const Point> at, std::string_view color, double diameter, double opacity = 1);
  /// Crosses of one colour.
  void crosses(std::span<const Point> at, std::string_view color, double size);
  /// A picture [edge, edge, 3] in a square.
  void image(Point corner, double size, int edge, std::span<const std::uint8_t> rgb);

  std::string svg() const { return marks_ + "</svg>\n"; }

 private:
  std::string marks_;
};

}  // namespace conceptplan::figures
