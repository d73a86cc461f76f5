#include "conceptplan/domain/files/checksum.hpp"

#include <gmock/gmock.h>

#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

TEST(Checksum, KnownValues) {
  EXPECT_EQ(crc32("123456789"), 0xcbf43926u);
  EXPECT_EQ(crc32(""), 0u);
  EXPECT_EQ(hexadecimal(0xcbf43926u), "cbf43926");
  EXPECT_EQ(hexadecimal(10), "0000000a");
}

TEST(Checksum, FileEqualsItsBytesAcrossPieces) {
  const TemporaryFolder folder;
  std::string bytes(200001, 'a');
  bytes[150000] = 'b';
  EXPECT_EQ(crc32OfFile(folder.write("file", bytes)), crc32(bytes));
  EXPECT_EQ(crc32OfFile(folder.write("empty", "")), 0u);
}

TEST(Checksum, OfJsonIsThatOfWhatItSays) {
  const std::uint32_t checksum = crc32OfJson(R"({"a": 1, "b": [0.5, "x"]})");
  EXPECT_EQ(checksum, crc32(R"({"a":1,"b":[0.5,"x"]})"));
  EXPECT_EQ(crc32OfJson(" {\"b\":[0.5,\"x\"],\n\"checksum\": \"1\", \"a\":1} "), checksum);
  EXPECT_NE(crc32OfJson(R"({"a": 2, "b": [0.5, "x"]})"), checksum);
  EXPECT_EQ(crc32OfJson("[1]"), 0U);
  EXPECT_EQ(crc32OfJson("{\"a\":"), 0U);
}

TEST(Checksum, FlippedBitIsFound) {
  std::string bytes(1000, 'a');
  const std::uint32_t before = crc32(bytes);
  bytes[500] ^= 1;
  EXPECT_NE(crc32(bytes), before);
}

TEST(Checksum, MissingFileIsAnInputError) {
  EXPECT_THAT(faultsOf([] { crc32OfFile("/absent/file"); }),
              testing::HasSubstr("/absent/file: file not found or unreadable"));
}

}  // namespace
}  // namespace conceptplan
