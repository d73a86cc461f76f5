#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/learned_symbols.hpp"
#include "conceptplan/learner/tensor_file.hpp"
#include "fuzz/damage.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

NamedTensors sample() {
  NamedTensors tensors{{"a", {{2, 3}, {1, 2, 3, 4, 5, 6}}}, {"b.c", {{1}, {-0.5F}}}};
  tensors["big"] = {{16, 16}, std::vector<float>(256, 0.25F)};
  return tensors;
}

std::string withHeader(const std::string& header, const std::string& data) {
  const std::uint64_t length = header.size();
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), &length, 8);
  return bytes + header + data;
}

/// What is accepted is whole: as many finite numbers as the shape says, which write and read alike.
void expectWhole(const NamedTensors& tensors) {
  for (const auto& [name, tensor] : tensors) {
    std::size_t count = 1;
    for (const auto edge : tensor.shape) count *= static_cast<std::size_t>(edge);
    ASSERT_EQ(tensor.values.size(), count) << name;
    for (const float value : tensor.values) ASSERT_TRUE(std::isfinite(value)) << name;
  }
  const NamedTensors again = decodeTensors(encodeTensors(tensors, TensorPrecision::kFloat32), "m");
  ASSERT_EQ(again.size(), tensors.size());
  for (const auto& [name, tensor] : tensors) ASSERT_EQ(again.at(name).values, tensor.values);
}

TEST(TensorFileFuzz, DamagedFilesAreRefusedOrWhole) {
  std::size_t refused = 0, accepted = 0;
  for (const auto precision : {TensorPrecision::kFloat32, TensorPrecision::kFloat16})
    testing::forEachDamage(encodeTensors(sample(), precision), 2000, 4000, 1,
                           [&](const std::string& bytes, const std::string& what) {
                             SCOPED_TRACE(what);
                             try {
                               expectWhole(decodeTensors(bytes, "m"));
                               ++accepted;
                             } catch (const InputError&) {
                               ++refused;
                             }
                           });
  EXPECT_GT(refused, 4000U);
  EXPECT_GT(accepted, 0U);  // numbers may change: the model's manifest has their checksum
}

TEST(TensorFileFuzz, HostileHeadersAreNamed) {
  const auto expect = [](const std::string& bytes, const char* message) {
    EXPECT_THAT([&] { decodeTensors(bytes, "m"); }, ThrowsMessage<InputError>(HasSubstr(message)));
  };
  const std::string eight = "12345678";
  expect(std::string(8, '\xff') + "{}", "the header is truncated");
  expect(std::string(8, '\0'), "not a JSON object");
  const auto entry = [](const std::string& name, const std::string& shape,
                        const std::string& offsets) {
    return "\"" + name + R"(":{"dtype":"F32","shape":)" + shape + R"(,"data_offsets":)" + offsets +
           "}";
  };
  // Both tensors over the same half of the data, the other half of nobody.
  expect(
      withHeader("{" + entry("a", "[1]", "[0,4]") + "," + entry("b", "[1]", "[0,4]") + "}", eight),
      "overlap or leave a gap");
  expect(
      withHeader("{" + entry("a", "[2]", "[0,8]") + "," + entry("b", "[2]", "[0,8]") + "}", eight),
      "overlap");
  // A name twice: the first entry's bytes are of nobody.
  expect(
      withHeader("{" + entry("a", "[1]", "[0,4]") + "," + entry("a", "[1]", "[4,8]") + "}", eight),
      "expected 4 bytes of numbers, found 8");
  for (const char* shape : {"[4294967296,4294967296]", "[-2]", "[1.5]", "[18446744073709551615]",
                            "\"2\"", "[[2]]", "null"})
    expect(withHeader("{" + entry("a", shape, "[0,8]") + "}", eight), "shape");
  for (const char* offsets :
       {"[8,0]", "[0,18446744073709551615]", "[-8,0]", "[0]", "[0,8,8]", "{}", "[0,9]"})
    expect(withHeader("{" + entry("a", "[2]", offsets) + "}", eight), "data_offsets");
  const std::string deep(200'000, '[');
  expect(withHeader(R"({"a":{"dtype":)" + deep + std::string(200'000, ']') + "}}", ""),
         "nested too deeply");
  expect(withHeader(R"({"a":{"dtype":["F32"],"shape":[2],"data_offsets":[0,8]}})", eight),
         "expected dtype F32 or F16");
  std::string nan(4, '\0');
  const float value = std::nanf("");
  std::memcpy(nan.data(), &value, 4);
  expect(withHeader("{" + entry("a", "[2]", "[0,8]") + "}", "1234" + nan), "not finite");
}

TEST(TensorFileFuzz, SymbolsOfImpossibleTensorsAreRefused) {
  std::array<SymbolClusters, kNumConcepts> clusters;
  std::array<std::vector<int>, kNumConcepts> values;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    clusters[k].centers =
        TokenMatrix::Random(static_cast<Eigen::Index>(kConceptCardinality[k]), 64);
    for (std::size_t i = 0; i < kConceptCardinality[k]; ++i)
      values[k].push_back(static_cast<int>(i));
  }
  SymbolGrounding grounding = standardGrounding();
  const NamedTensors good =
      tensorsOf(LearnedSymbols{Symbolizer(clusters), grounding, values, {1, 1, 1}});
  std::mt19937_64 generator(3);
  std::size_t refused = 0;
  for (const auto& [name, tensor] : good)
    for (int change = 0; change < 40; ++change) {
      NamedTensors changed = good;
      NamedTensor& hit = changed[name];
      switch (change % 4) {
        case 0:  // another shape
          hit.shape.push_back(1);
          break;
        case 1:  // fewer numbers
          hit.values.resize(hit.values.size() / 2);
          hit.shape = {static_cast<std::int64_t>(hit.values.size())};
          break;
        case 2:  // missing
          changed.erase(name);
          break;
        default:  // an impossible number
          hit.values[generator() % hit.values.size()] =
              std::array{-1.0F, 0.5F, 3e9F, -3e38F}[generator() % 4];
      }
      try {
        const LearnedSymbols read = learnedSymbolsFrom(changed, "m");
        EXPECT_TRUE(read.grounding.faults(read.symbolizer.cardinality()).empty());
        EXPECT_EQ(change % 4, 3) << name;  // centres may be any number of sense
        for (const auto& belief : read.symbolizer.belief(Tokens::Constant(1)))
          for (const double p : belief) EXPECT_TRUE(p >= 0 && p <= 1) << name << ": " << p;
      } catch (const InputError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, good.size() * 30);
}

}  // namespace
}  // namespace conceptplan
