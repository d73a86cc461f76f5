#include "svg_drawing.hpp"

#include "report_markup.hpp"

namespace conceptplan::figures {
namespace {

using report::attribute;

std::string number(double value) { return report::decimal(value, 1); }

constexpr std::string_view kAnchors[] = {"start", "middle", "end"};

}  // namespace

SvgDrawing::SvgDrawing(double width, double height, const std::string& title,
                       const std::string& description)
    : marks_(
          "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 " + number(width) +
          " " + number(height) + "\"" + attribute("width", width) + attribute("height", height) +
          " font-family=\"Helvetica Neue, Helvetica, Arial, DejaVu Sans, sans-serif\">\n<title>" +
          report::escaped(title) + "</title>\n<desc>" + report::escaped(description) +
          "</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n") {}

void SvgDrawing::text(Point at, std::string_view content, const TextStyle& style) {
  marks_ += "<text" + attribute("x", at.x) + attribute("y", at.y) +
            attribute("font-size", style.size) +
            attribute("text-anchor", kAnchors[static_cast<int>(style.anchor)]) +
            (style.bold ? attribute("font-weight", "600") : "") + attribute("fill", style.color) +
            ">" + report::escaped(content) + "</text>\n";
}

void SvgDrawing::line(Point from, Point to, std::string_view color, double width) {
  marks_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
            attribute("y2", to.y) + attribute("stroke", color) + attribute("stroke-width", width) +
            "/>\n";
}

void SvgDrawing::rectangle(Point corner, double width, double height, std::string_view fill,
                           std::string_view stroke) {
  marks_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) +
            attribute("width", width) + attribute("height", height) + attribute("fill", fill) +
            attribute("stroke", stroke) + "/>\n";
}

void SvgDrawing::dots(std::span<const Point> at, std::string_view color, double diameter,
                      double opacity) {
  // Round ends of lines without length: the shortest way to write many discs.
  marks_ += "<path fill=\"none\" stroke-linecap=\"round\"" + attribute("stroke-opacity", opacity) +
            attribute("stroke", color) + attribute("stroke-width", diameter) + " d=\"";
  for (const Point& point : at) marks_ += "M" + number(point.x) + " " + number(point.y) + "h0";
  marks_ += "\"/>\n";
}

void SvgDrawing::crosses(std::span<const Point> at, std::string_view color, double size) {
  const std::string edge = number(size), back = number(-size);
  marks_ += "<path fill=\"none\" stroke-width=\"1.5\"" + attribute("stroke", color) + " d=\"";
  for (const Point& point : at)
    marks_ += "M" + number(point.x - size / 2) + " " + number(point.y - size / 2) + "l" + edge +
              " " + edge + "m" + back + " 0l" + edge + " " + back;
  marks_ += "\"/>\n";
}

void SvgDrawing::image(Point corner, double size, int edge, std::span<const std::uint8_t> rgb) {
  marks_ += "<image" + attribute("x", corner.x) + attribute("y", corner.y) +
            attribute("width", size) + attribute("height", size) +
            attribute("href", report::dataUri(edge, edge, rgb)) + "/>\n";
}

}  // namespace conceptplan::figures
