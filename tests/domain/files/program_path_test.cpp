#include "conceptplan/domain/files/program_path.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "temporary_folder.hpp"

namespace conceptplan {
namespace {

/// PATH for the length of a test.
class ScopedPath {
 public:
  explicit ScopedPath(const std::string& path) : before_(std::getenv("PATH")) {
    ::setenv("PATH", path.c_str(), 1);
  }
  ~ScopedPath() { ::setenv("PATH", before_.c_str(), 1); }
  ScopedPath(const ScopedPath&) = delete;
  ScopedPath& operator=(const ScopedPath&) = delete;

 private:
  std::string before_;
};

std::filesystem::path program(const std::filesystem::path& file, bool executable) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << "#!/bin/sh\n";
  std::filesystem::permissions(
      file, executable ? std::filesystem::perms::owner_all : std::filesystem::perms::owner_read);
  return file;
}

TEST(FindOnPath, TakesTheFirstExecutableFileInAnAbsoluteFolder) {
  const TemporaryFolder folder;
  const auto text = program(folder.path() / "a" / "planner", false);
  std::filesystem::create_directories(folder.path() / "b" / "planner");
  const auto first = program(folder.path() / "c" / "planner", true);
  program(folder.path() / "d" / "planner", true);
  std::string path = ".:";
  for (const char* name : {"a", "none", "b", "c", "d"}) {
    path += (folder.path() / name).string() + ":";
  }
  const ScopedPath scoped(path);
  EXPECT_EQ(findOnPath("planner"), first);
  EXPECT_EQ(findOnPath("other"), std::nullopt);
}

}  // namespace
}  // namespace conceptplan
