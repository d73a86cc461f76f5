#include "conceptplan/domain/files/rgbd_image_file.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "png_format.hpp"

namespace conceptplan {
namespace {

constexpr std::uint32_t kMaxEdge = 8192;

struct ChannelFormat {
  const char* key;
  int bit_depth;
  bool color;
  const char* text;
};

constexpr ChannelFormat kRgb{"rgb", 8, true, "8-bit RGB"};
constexpr ChannelFormat kDepth{"depth", 16, false, "16-bit grey (millimetres)"};
constexpr ChannelFormat kMask{"mask", 8, false, "8-bit grey (instance ids)"};

bool fits(const PngHeader& header, const ChannelFormat& format) {
  const bool color = header.color_type == 2 || header.color_type == 6;
  const bool grey = header.color_type == 0;
  return header.bit_depth == format.bit_depth && (format.color ? color : grey);
}

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// The decoded file, or nothing with its faults added.
std::optional<cv::Mat> readChannel(const std::filesystem::path& path, const ChannelFormat& format,
                                   std::vector<Fault>& faults) {
  const auto refuse = [&](std::string message) {
    faults.push_back({path.string(), {}, {}, format.key, std::move(message)});
    return std::nullopt;
  };
  std::string bytes;
  try {
    bytes = readFile(path);
  } catch (const InputError& error) {
    return refuse(error.faults().front().message);
  }
  std::string reason;
  const std::optional<PngHeader> header = checkPng(bytes, reason);
  if (!header) return refuse(reason);
  if (!fits(*header, format)) {
    return refuse(std::string("expected ") + format.text + ", found " + header->text());
  }
  if (header->width == 0 || header->height == 0 || header->width > kMaxEdge ||
      header->height > kMaxEdge) {
    return refuse("expected at most " + sizeText(kMaxEdge, kMaxEdge) + " pixels, found " +
                  std::to_string(header->width) + " x " + std::to_string(header->height));
  }
  cv::Mat decoded;
  try {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, bytes.data());
    decoded = cv::imdecode(raw, format.color ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    decoded.release();
  }
  if (decoded.empty()) return refuse("damaged PNG: the picture cannot be decoded");
  if (format.color) cv::cvtColor(decoded, decoded, cv::COLOR_BGR2RGB);
  return decoded;
}

template <typename Pixel>
std::vector<Pixel> values(const cv::Mat& matrix) {
  const cv::Mat whole = matrix.isContinuous() ? matrix : matrix.clone();
  const auto* first = whole.ptr<Pixel>();
  return {first, first + whole.total() * static_cast<std::size_t>(whole.channels())};
}

std::string encode(const cv::Mat& matrix) {
  std::vector<std::uint8_t> bytes;
  const std::vector<int> parameters{cv::IMWRITE_PNG_COMPRESSION, 1};
  if (!cv::imencode(".png", matrix, bytes, parameters)) {
    throw std::runtime_error("a picture could not be encoded as PNG");
  }
  return {bytes.begin(), bytes.end()};
}

void requireSize(const char* what, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  throw std::invalid_argument(std::string(what) + ": expected " + std::to_string(expected) +
                              " values, found " + std::to_string(found));
}

std::size_t pixelCount(int width, int height) {
  if (width <= 0 || height <= 0) {
    throw std::invalid_argument("a picture of " + sizeText(width, height) + " pixels");
  }
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

std::uint16_t millimetres(float depth_m) {
  const float scaled = std::round(depth_m * 1000.0f);
  return static_cast<std::uint16_t>(std::clamp(scaled, 0.0f, 65535.0f));
}

}  // namespace

RgbdPaths rgbdPaths(const std::filesystem::path& stem) {
  return {stem.string() + ".rgb.png", stem.string() + ".depth.png", stem.string() + ".mask.png"};
}

void writeRgbdImage(const std::filesystem::path& stem, const RgbdImage& image) {
  const std::size_t pixels = pixelCount(image.width, image.height);
  requireSize("depth", image.depth_m.size(), pixels);
  requireSize("mask", image.mask.size(), pixels);
  cv::Mat depth(image.height, image.width, CV_16U);
  std::transform(image.depth_m.begin(), image.depth_m.end(), depth.begin<std::uint16_t>(),
                 millimetres);
  const cv::Mat mask(image.height, image.width, CV_8U,
                     const_cast<std::uint8_t*>(image.mask.data()));
  const RgbdPaths paths = rgbdPaths(stem);
  writeFileAtomically(paths.rgb, encodePng(image.width, image.height, image.rgb));
  writeFileAtomically(paths.depth, encode(depth));
  writeFileAtomically(paths.mask, encode(mask));
}

RgbdImage readRgbdImage(const RgbdPaths& paths) {
  std::vector<Fault> faults;
  const std::optional<cv::Mat> rgb = readChannel(paths.rgb, kRgb, faults);
  const std::optional<cv::Mat> depth = readChannel(paths.depth, kDepth, faults);
  const std::optional<cv::Mat> mask = readChannel(paths.mask, kMask, faults);
  const auto compareSize = [&](const std::optional<cv::Mat>& channel, const ChannelFormat& format,
                               const std::filesystem::path& path) {
    if (!rgb || !channel || channel->size() == rgb->size()) return;
    faults.push_back({path.string(),
                      {},
                      {},
                      format.key,
                      "expected the size of the RGB picture, " + sizeText(rgb->cols, rgb->rows) +
                          ", found " + sizeText(channel->cols, channel->rows)});
  };
  compareSize(depth, kDepth, paths.depth);
  compareSize(mask, kMask, paths.mask);
  if (!faults.empty()) throw InputError(std::move(faults));

  RgbdImage image;
  image.width = rgb->cols;
  image.height = rgb->rows;
  image.rgb = values<std::uint8_t>(*rgb);
  image.mask = values<std::uint8_t>(*mask);
  image.depth_m.reserve(depth->total());
  for (const std::uint16_t value : values<std::uint16_t>(*depth)) {
    image.depth_m.push_back(static_cast<float>(value) * 0.001f);
  }
  return image;
}

std::string encodePng(int width, int height, std::span<const std::uint8_t> rgb) {
  requireSize("rgb", rgb.size(), 3 * pixelCount(width, height));
  const cv::Mat picture(height, width, CV_8UC3, const_cast<std::uint8_t*>(rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(picture, bgr, cv::COLOR_RGB2BGR);
  return encode(bgr);
}

RgbdImage readRgbImage(const std::filesystem::path& path) {
  std::vector<Fault> faults;
  const std::optional<cv::Mat> rgb = readChannel(path, kRgb, faults);
  if (!rgb) throw InputError(std::move(faults));
  RgbdImage image;
  image.width = rgb->cols;
  image.height = rgb->rows;
  image.rgb = values<std::uint8_t>(*rgb);
  return image;
}

}  // namespace conceptplan
