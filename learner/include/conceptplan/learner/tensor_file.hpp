#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace conceptplan {

/// Numbers with a shape, row-major.
struct NamedTensor {
  std::vector<std::int64_t> shape;
  std::vector<float> values;
};

using NamedTensors = std::map<std::string, NamedTensor>;

enum class TensorPrecision { kFloat32, kFloat16 };

/// The tensors in the safetensors format: eight bytes of header length, a JSON header, raw
/// little-endian numbers. Source: huggingface.co/docs/safetensors.
std::string encodeTensors(const NamedTensors& tensors, TensorPrecision precision);

/// @param path stands in the fault. @throws InputError if the bytes are not a well-formed
/// safetensors file of 32- or 16-bit floating-point tensors without overlaps or gaps, or hold a
/// number that is not finite.
NamedTensors decodeTensors(std::string_view bytes, const std::filesystem::path& path);

}  // namespace conceptplan
