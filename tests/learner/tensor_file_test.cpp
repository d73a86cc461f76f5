#include "conceptplan/learner/tensor_file.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <limits>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

NamedTensors sample() {
  return {{"a", {{2, 3}, {1, 2, 3, 4, 5, 6}}}, {"b.c", {{1}, {-0.5F}}}, {"scalar", {{}, {7}}}};
}

std::string withHeader(const std::string& header, const std::string& data) {
  const std::uint64_t length = header.size();
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), &length, 8);
  return bytes + header + data;
}

TEST(TensorFile, ReadsWhatItWrote) {
  for (const auto precision : {TensorPrecision::kFloat32, TensorPrecision::kFloat16}) {
    const NamedTensors read = decodeTensors(encodeTensors(sample(), precision), "m");
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read.at("a").shape, (std::vector<std::int64_t>{2, 3}));
    EXPECT_EQ(read.at("a").values, sample().at("a").values);
    EXPECT_EQ(read.at("b.c").values, std::vector<float>{-0.5F});
    EXPECT_TRUE(read.at("scalar").shape.empty());
  }
}

TEST(TensorFile, HalfPrecisionHalvesTheNumbers) {
  NamedTensors large{{"x", {{1000}, std::vector<float>(1000, 1.5F)}}};
  EXPECT_NEAR(static_cast<double>(encodeTensors(large, TensorPrecision::kFloat32).size()) -
                  static_cast<double>(encodeTensors(large, TensorPrecision::kFloat16).size()),
              2000, 16);
}

TEST(TensorFile, EveryTruncationIsAnInputError) {
  const std::string bytes = encodeTensors(sample(), TensorPrecision::kFloat32);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(decodeTensors(bytes.substr(0, length), "m"), InputError) << length;
}

TEST(TensorFile, NoFlippedByteCrashesOrGivesNumbersThatAreNotFinite) {
  const std::string bytes = encodeTensors(sample(), TensorPrecision::kFloat32);
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const char flip : {'\x01', '\x40', '\xff'}) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      try {
        for (const auto& [name, tensor] : decodeTensors(damaged, "m"))
          for (const float value : tensor.values) EXPECT_TRUE(std::isfinite(value));
      } catch (const InputError&) {
      }
    }
}

TEST(TensorFile, NamesWhatIsWrong) {
  EXPECT_THAT([] { decodeTensors("abc", "model.bin"); },
              ThrowsMessage<InputError>(HasSubstr("model.bin")));
  EXPECT_THAT([] { decodeTensors(withHeader("[1]", ""), "m"); },
              ThrowsMessage<InputError>(HasSubstr("not a JSON object")));
  EXPECT_THAT(
      [] {
        decodeTensors(
            withHeader(R"({"t":{"dtype":"I64","shape":[1],"data_offsets":[0,8]}})", "12345678"),
            "m");
      },
      ThrowsMessage<InputError>(HasSubstr("expected dtype F32 or F16, found \"I64\"")));
  EXPECT_THAT(
      [] {
        decodeTensors(
            withHeader(R"({"t":{"dtype":"F32","shape":[9],"data_offsets":[0,4]}})", "1234"), "m");
      },
      ThrowsMessage<InputError>(HasSubstr("shape")));
  const float infinity = std::numeric_limits<float>::infinity();
  const NamedTensors infinite{{"t", {{1}, {infinity}}}};
  EXPECT_THAT([&] { decodeTensors(encodeTensors(infinite, TensorPrecision::kFloat32), "m"); },
              ThrowsMessage<InputError>(HasSubstr("not finite")));
}

}  // namespace
}  // namespace conceptplan
