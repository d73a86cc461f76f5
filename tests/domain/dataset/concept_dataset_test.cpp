#include "conceptplan/domain/dataset/concept_dataset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/dataset/task_dataset_writer.hpp"
#include "conceptplan/domain/files/atomic_file.hpp"
#include "domain/dataset/reseal.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;

constexpr std::size_t kPixels = std::size_t{ObjectCrop::kEdge} * ObjectCrop::kEdge;
constexpr ConceptDatasetOptions kOptions{.split = Split::kValidation, .samples = 1, .seed = 5};

/// A crop with a few pixels that depend on the object and sample.
ObjectCrop smallCrop(const ObjectState& object, int sample) {
  ObjectCrop crop;
  crop.rgb.assign(kPixels * 3, 0);
  crop.depth_m.assign(kPixels, 0);
  crop.mask.assign(kPixels, 0);
  const auto pixel = static_cast<std::size_t>(index(combinationOf(object)) % kPixels);
  crop.rgb[pixel * 3] = static_cast<std::uint8_t>(1 + sample);
  crop.depth_m[pixel] = 1.5F + 0.0001F * static_cast<float>(object.color);
  crop.mask[pixel] = 1;
  crop.left = -3 - object.cell.x;
  crop.top = 10 + object.cell.y;
  return crop;
}

void writeShard(const ConceptDatasetWriter& writer, std::size_t shard) {
  std::vector<ObjectCrop> crops;
  for (const auto& request : writer.requests(shard))
    crops.push_back(smallCrop(request.object, request.sample));
  writer.write(shard, crops);
}

void writeDataset(const std::filesystem::path& folder, const ConceptDatasetOptions& options) {
  const ConceptDatasetWriter writer(folder, options);
  for (const std::size_t shard : writer.pendingShards()) writeShard(writer, shard);
  writer.finish();
}

std::string readingFaults(const std::filesystem::path& folder) {
  return faultsOf([&] { ConceptDataset{folder}; });
}

TEST(ConceptDataset, ReadsWhatWasWritten) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), kOptions);
  const ConceptDataset dataset(folder.path());
  EXPECT_EQ(dataset.options(), kOptions);
  EXPECT_EQ(dataset.size(), 1152u);
  EXPECT_EQ(dataset.combinations(), ConceptSet(5).combinations(Split::kValidation));
  for (std::size_t i = 0; i < dataset.size(); i += 13) {
    const ConceptSample sample = dataset.sample(i);
    const ObjectCrop expected = smallCrop(sample.object, sample.sample);
    EXPECT_EQ(combinationOf(sample.object), dataset.combinations()[i]);
    EXPECT_EQ(dataset.position(combinationOf(sample.object), 0), i);
    EXPECT_EQ(sample.crop.rgb, expected.rgb);
    EXPECT_EQ(sample.crop.mask, expected.mask);
    EXPECT_EQ(sample.crop.left, expected.left);
    EXPECT_EQ(sample.crop.top, expected.top);
    for (std::size_t p = 0; p < kPixels; ++p)
      ASSERT_NEAR(sample.crop.depth_m[p], expected.depth_m[p], 0.00005);
  }
}

TEST(ConceptDataset, SamplesOfOneCombinationFollowEachOther) {
  const TemporaryFolder folder;
  const ConceptDatasetOptions options{.split = Split::kValidation, .samples = 2, .seed = 5};
  writeDataset(folder.path(), options);
  const ConceptDataset dataset(folder.path());
  EXPECT_EQ(dataset.size(), 2304u);
  const CombinationId combination = dataset.combinations()[700];
  for (int sample = 0; sample < 2; ++sample) {
    const std::size_t position = dataset.position(combination, sample);
    EXPECT_EQ(position, 1400u + static_cast<std::size_t>(sample));
    EXPECT_EQ(combinationOf(dataset.sample(position).object), combination);
    EXPECT_EQ(dataset.sample(position).sample, sample);
  }
}

TEST(ConceptDataset, WhatIsNotInTheSetIsABrokenPrecondition) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), kOptions);
  const ConceptDataset dataset(folder.path());
  EXPECT_THAT([&] { dataset.sample(1152); },
              testing::ThrowsMessage<std::invalid_argument>("sample 1152 of 1152"));
  const CombinationId trained = ConceptSet(5).combinations(Split::kTrain)[0];
  EXPECT_THAT(
      [&] { dataset.position(trained, 0); },
      testing::ThrowsMessage<std::invalid_argument>(HasSubstr("is not in the validation split")));
  EXPECT_THROW(dataset.position(dataset.combinations()[0], 1), std::invalid_argument);
}

TEST(ConceptDataset, MissingAndTruncatedShardsAreAllTold) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), kOptions);
  const std::string bytes = readFile(folder / "concepts-00000.bin");
  writeFileAtomically(folder / "concepts-00000.bin", bytes.substr(0, 1000));
  std::filesystem::remove(folder / "concepts-00001.bin");
  const std::string faults = readingFaults(folder.path());
  EXPECT_THAT(faults, HasSubstr("concepts-00000.bin: expected " + std::to_string(bytes.size()) +
                                " bytes, found 1000"));
  EXPECT_THAT(faults, HasSubstr("concepts-00001.bin"));
  writeFileAtomically(folder / "concepts-00000.bin", "");
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("is empty"));
}

TEST(ConceptDataset, AShardOfAnotherFormatIsRefused) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), kOptions);
  std::string bytes = readFile(folder / "concepts-00001.bin");
  bytes[8] = 2;
  writeFileAtomically(folder / "concepts-00001.bin", bytes);
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("its header differs"));
}

TEST(ConceptDataset, ADamagedRecordIsFoundWhenItIsRead) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), kOptions);
  std::string bytes = readFile(folder / "concepts-00000.bin");
  bytes[bytes.size() - 1] = static_cast<char>(bytes.back() ^ 1);
  writeFileAtomically(folder / "concepts-00000.bin", bytes);
  const ConceptDataset dataset(folder.path());
  EXPECT_NO_THROW(dataset.sample(0));
  EXPECT_THAT(faultsOf([&] { dataset.sample(959); }),
              HasSubstr("concepts-00000.bin: a record is damaged"));
}

TEST(ConceptDataset, ARecordWithoutAPixelOnItsObjectIsRefused) {
  const TemporaryFolder folder;
  writeDataset(folder.path(), kOptions);
  std::string bytes = readFile(folder / "concepts-00000.bin");
  const std::size_t depths = 16 + 3 * kPixels;
  bytes.replace(kRecordsBegin + 7 * kRecordBytes + depths, 2 * kPixels, 2 * kPixels, '\0');
  resealRecord(bytes, 7);
  writeFileAtomically(folder / "concepts-00000.bin", bytes);
  const ConceptDataset dataset(folder.path());
  EXPECT_THAT(faultsOf([&] { dataset.sample(7); }),
              HasSubstr("concepts-00000.bin: record 7 has no pixel on its object"));
  EXPECT_NO_THROW(dataset.sample(8));
}

TEST(ConceptDataset, ASetOfTasksIsRefused) {
  const TemporaryFolder folder;
  TaskDatasetOptions tasks;
  tasks.count = 1;
  tasks.frames = Frames::kNone;
  TaskDatasetWriter(folder.path(), tasks).finish();
  EXPECT_THAT(readingFaults(folder.path()),
              HasSubstr("expected a dataset of concepts, found one of tasks"));
}

TEST(ConceptDatasetWriter, AnInterruptedSetIsContinued) {
  const TemporaryFolder folder;
  const ConceptDatasetWriter first(folder.path(), kOptions);
  EXPECT_THAT(first.pendingShards(), testing::ElementsAre(0, 1));
  writeShard(first, 1);
  EXPECT_THAT(readingFaults(folder.path()), HasSubstr("the generation was interrupted"));
  const ConceptDatasetWriter second(folder.path(), kOptions);
  EXPECT_THAT(second.pendingShards(), testing::ElementsAre(0));
  EXPECT_NE(faultsOf([&] { second.finish(); }), "");
  writeShard(second, 0);
  second.finish();
  EXPECT_EQ(ConceptDataset(folder.path()).size(), 1152u);
}

TEST(ConceptDatasetWriter, RequestsHaveTheAppearancesOfTheSet) {
  const TemporaryFolder folder;
  const ConceptDatasetWriter writer(folder.path(), kOptions);
  const ConceptSet set(5);
  for (const auto& request : writer.requests(1)) {
    const CombinationId combination = combinationOf(request.object);
    EXPECT_EQ(set.split(combination), Split::kValidation);
    EXPECT_EQ(request.appearance, set.appearance(combination, request.sample));
  }
  EXPECT_EQ(writer.requests(0).size(), 960u);
  EXPECT_EQ(writer.requests(1).size(), 192u);
  EXPECT_THROW(writer.requests(2), std::invalid_argument);
}

TEST(ConceptDatasetWriter, CropsOfAnotherShapeAreRefused) {
  const TemporaryFolder folder;
  const ConceptDatasetWriter writer(folder.path(), kOptions);
  EXPECT_THAT([&] { writer.write(1, {}); },
              testing::ThrowsMessage<std::invalid_argument>("shard 1 has 192 crops, not 0"));
  std::vector<ObjectCrop> crops;
  for (const auto& request : writer.requests(1))
    crops.push_back(smallCrop(request.object, request.sample));
  crops[5].mask.resize(10);
  EXPECT_THROW(writer.write(1, crops), std::invalid_argument);
  crops[5] = crops[4];
  crops[5].mask.assign(kPixels, 1);
  EXPECT_THAT([&] { writer.write(1, crops); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("of a pixel on the object")));
  crops[5].mask.assign(kPixels, 0);
  EXPECT_THAT([&] { writer.write(1, crops); },
              testing::ThrowsMessage<std::invalid_argument>("a crop has no pixel on its object"));
  EXPECT_FALSE(std::filesystem::exists(folder / "concepts-00001.bin"));
  EXPECT_THROW(ConceptDatasetWriter(folder / "x", {.samples = 21}), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
