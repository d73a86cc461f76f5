#include "conceptplan/domain/rendering/contact_sheet.hpp"

#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

constexpr int kTile = ObjectCrop::kEdge;
constexpr int kLabelWidth = 110;
constexpr int kLabelHeight = 24;

/// A grid of tiles with a label before each row and above each column.
class Sheet {
 public:
  Sheet(int rows, int columns, int scale)
      : tile_(kTile * scale),
        canvas_(kLabelHeight + rows * tile_, kLabelWidth + columns * tile_, CV_8UC3,
                cv::Scalar::all(250)) {}

  void labelRow(int row, const std::string& text) {
    write(text, {6, kLabelHeight + row * tile_ + tile_ / 2 + 5});
  }
  void labelColumn(int column, const std::string& text) {
    write(text, {kLabelWidth + column * tile_ + 6, kLabelHeight - 7});
  }
  /// The surroundings of the only object of the picture.
  void place(int row, int column, RgbdImage image) {
    const ObjectCrop crop = cropObject(image, 1);
    const cv::Mat frame(image.height, image.width, CV_8UC3, image.rgb.data());
    cv::Mat spot =
        canvas_(cv::Rect(kLabelWidth + column * tile_, kLabelHeight + row * tile_, tile_, tile_));
    cv::resize(frame(cv::Rect(crop.left, crop.top, kTile, kTile)), spot, spot.size(), 0, 0,
               cv::INTER_CUBIC);
  }
  Picture picture() const {
    return {canvas_.cols, canvas_.rows, {canvas_.datastart, canvas_.dataend}};
  }

 private:
  void write(const std::string& text, cv::Point at) {
    cv::putText(canvas_, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar::all(30), 1,
                cv::LINE_AA);
  }

  int tile_;
  cv::Mat canvas_;
};

void check(const ContactSheetOptions& options) {
  if (options.scale >= 1 && options.scale <= 8) return;
  throw std::invalid_argument("contact sheet: expected a scale in [1, 8], found " +
                              std::to_string(options.scale));
}

RgbdImage middle(Renderer& renderer, ObjectState object, const Appearance& appearance) {
  World world;
  object.cell = {world.workbench.columns / 2, world.workbench.rows / 2};
  world.objects = {object};
  return renderer.render(world, appearance);
}

}  // namespace

Picture rotationSheet(Renderer& renderer, const ContactSheetOptions& options) {
  check(options);
  Sheet sheet(kNumObjectTypes, 4, options.scale);
  for (int rotation = 0; rotation < 4; ++rotation) {
    sheet.labelColumn(rotation, std::to_string(90 * rotation) + " degrees");
  }
  for (int row = 0; row < static_cast<int>(kNumObjectTypes); ++row) {
    const auto type = static_cast<ObjectType>(row);
    sheet.labelRow(row, std::string(name(type)));
    for (int rotation = 0; rotation < 4; ++rotation) {
      sheet.place(row, rotation,
                  middle(renderer, {type, {}, rotation, row % 6, 3}, options.appearance));
    }
  }
  return sheet.picture();
}

Picture colorAndSizeSheet(Renderer& renderer, ObjectType type, const ContactSheetOptions& options) {
  check(options);
  Sheet sheet(6, 4, options.scale);
  for (int size = 0; size < 4; ++size)
    sheet.labelColumn(size, "size " + std::to_string(size + 1) + " of 4");
  for (int color = 0; color < 6; ++color) {
    sheet.labelRow(color, std::string(colorName(color)));
    for (int size = 0; size < 4; ++size) {
      sheet.place(color, size, middle(renderer, {type, {}, 0, color, size}, options.appearance));
    }
  }
  return sheet.picture();
}

}  // namespace conceptplan
