#include "conceptplan/learner/tensor_file.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "conceptplan/domain/files/json_depth.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

static_assert(std::endian::native == std::endian::little, "safetensors are little-endian");

using Json = nlohmann::json;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& key,
                       const std::string& message) {
  throw InputError({Fault{path.string(), std::nullopt, std::nullopt, key, message}});
}

std::size_t count(const std::vector<std::int64_t>& shape) {
  std::size_t product = 1;
  for (const auto edge : shape) product *= static_cast<std::size_t>(edge);
  return product;
}

/// The shape of a header entry, refused unless its product is at most `limit`.
std::vector<std::int64_t> readShape(const Json& entry, std::size_t limit,
                                    const std::filesystem::path& path, const std::string& name) {
  if (!entry.contains("shape") || !entry["shape"].is_array()) fail(path, name, "expected a shape");
  std::vector<std::int64_t> shape;
  std::size_t product = 1;
  for (const Json& edge : entry["shape"]) {
    if (!edge.is_number_unsigned() || edge.get<std::uint64_t>() > limit)
      fail(path, name, "expected a shape of sizes that fit the file");
    shape.push_back(edge.get<std::int64_t>());
    product *= static_cast<std::size_t>(shape.back());
    if (product > limit) fail(path, name, "expected a shape that fits the file");
  }
  return shape;
}

}  // namespace

std::string encodeTensors(const NamedTensors& tensors, TensorPrecision precision) {
  const bool half = precision == TensorPrecision::kFloat16;
  Json header = Json::object();
  std::string data;
  for (const auto& [name, tensor] : tensors) {
    const std::size_t begin = data.size();
    for (const float value : tensor.values) {
      char bytes[sizeof(float)];
      if (half) {
        const Eigen::half narrow(value);
        std::memcpy(bytes, &narrow, 2);
      } else {
        std::memcpy(bytes, &value, 4);
      }
      data.append(bytes, half ? 2 : 4);
    }
    header[name] = {{"dtype", half ? "F16" : "F32"},
                    {"shape", tensor.shape},
                    {"data_offsets", {begin, data.size()}}};
  }
  std::string text = header.dump();
  text.resize((text.size() + 7) / 8 * 8, ' ');
  const std::uint64_t length = text.size();
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  return bytes + text + data;
}

NamedTensors decodeTensors(std::string_view bytes, const std::filesystem::path& path) {
  std::uint64_t length = 0;
  if (bytes.size() < sizeof length)
    fail(path, "", "expected a safetensors file, found " + std::to_string(bytes.size()) + " bytes");
  std::memcpy(&length, bytes.data(), sizeof length);
  if (length > bytes.size() - sizeof length)
    fail(path, "", "the header is truncated: expected " + std::to_string(length) + " bytes");
  const std::string_view header_text = bytes.substr(sizeof length, length);
  if (nestsTooDeep(header_text)) fail(path, "", "the header is nested too deeply");
  const Json header = Json::parse(header_text, nullptr, /*allow_exceptions=*/false);
  if (!header.is_object()) fail(path, "", "the header is not a JSON object");
  const std::string_view data = bytes.substr(sizeof length + length);

  NamedTensors tensors;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> spans;  // of bytes, one a tensor
  std::size_t total = 0;
  for (const auto& [name, entry] : header.items()) {
    if (name == "__metadata__") continue;
    if (!entry.is_object() || !entry.contains("dtype") || !entry.contains("data_offsets"))
      fail(path, name, "expected dtype, shape and data_offsets");
    const bool half = entry["dtype"] == "F16";
    if (!half && entry["dtype"] != "F32")
      fail(path, name, "expected dtype F32 or F16, found " + entry["dtype"].dump());
    const std::size_t width = half ? 2 : 4;
    NamedTensor tensor{readShape(entry, data.size() / width, path, name), {}};
    const Json& offsets = entry["data_offsets"];
    if (!offsets.is_array() || offsets.size() != 2 || !offsets[0].is_number_unsigned() ||
        !offsets[1].is_number_unsigned())
      fail(path, name, "expected two data_offsets");
    const auto begin = offsets[0].get<std::uint64_t>(), end = offsets[1].get<std::uint64_t>();
    if (begin > end || end > data.size() || end - begin != count(tensor.shape) * width)
      fail(path, name, "data_offsets do not fit the shape or the file");
    total += end - begin;
    if (total > data.size()) fail(path, name, "data_offsets overlap those of other tensors");
    spans.emplace_back(begin, end);
    tensor.values.resize(count(tensor.shape));
    for (std::size_t i = 0; i < tensor.values.size(); ++i) {
      const char* from = data.data() + begin + i * width;
      if (half) {
        Eigen::half narrow;
        std::memcpy(&narrow, from, 2);
        tensor.values[i] = static_cast<float>(narrow);
      } else {
        std::memcpy(&tensor.values[i], from, 4);
      }
      if (!std::isfinite(tensor.values[i])) fail(path, name, "holds a number that is not finite");
    }
    tensors.emplace(name, std::move(tensor));
  }
  if (total != data.size())
    fail(path, "",
         "expected " + std::to_string(total) + " bytes of numbers, found " +
             std::to_string(data.size()));
  std::sort(spans.begin(), spans.end());
  std::uint64_t covered = 0;
  for (const auto& [begin, end] : spans) {
    if (begin != covered)
      fail(path, "", "data_offsets overlap or leave a gap at byte " + std::to_string(begin));
    covered = end;
  }
  return tensors;
}

}  // namespace conceptplan
