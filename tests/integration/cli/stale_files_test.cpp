#include "stale_files.hpp"

#include <gmock/gmock.h>

#include <set>

#include "domain/files/temporary_folder.hpp"

namespace conceptplan::cli {
namespace {

using testing::HasSubstr;

std::string name(std::size_t number) {
  return std::string("step-") + (number < 10 ? "0" : "") + std::to_string(number) + ".png";
}

TEST(StaleFiles, OnlyFilesThatACommandNamesSoAreRemoved) {
  const TemporaryFolder folder;
  for (const char* stale : {"step-01.png", "step-99.png", "step-100.png"}) folder.write(stale, "");
  const std::set<std::string> others{"step-00.png",  "step-1.png", "step-001.png",
                                     "step-.png",    "step-01",    "my-step-01.png",
                                     "step-01.png~", "notes.txt",  "step-99999999999999999999.png"};
  for (const std::string& other : others) folder.write(other, "");
  std::filesystem::create_directory(folder / "step-02.png");
  removeStale(folder.path(), name);
  std::set<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (entry.is_regular_file()) left.insert(entry.path().filename());
  }
  EXPECT_EQ(left, others);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "step-02.png"));
}

TEST(StaleFiles, AFileThatIsNotThereIsNoFault) {
  const TemporaryFolder folder;
  const auto file = folder.write("result.json", "");
  removeStale(file);
  EXPECT_FALSE(std::filesystem::exists(file));
  removeStale(file);
}

TEST(StaleFiles, WhatCannotBeRemovedIsNamed) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "result.json/below");
  EXPECT_THAT(faultsOf([&] { removeStale(folder / "result.json"); }),
              HasSubstr("result.json: cannot be removed: "));
}

}  // namespace
}  // namespace conceptplan::cli
