#include "conceptplan/domain/files/atomic_file.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>

#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;

TEST(AtomicFile, ReadsWhatWasWritten) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  writeFileAtomically(folder / "file", bytes);
  EXPECT_EQ(readFile(folder / "file"), bytes);
  writeFileAtomically(folder / "file", "");
  EXPECT_EQ(readFile(folder / "file"), "");
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, MissingFolderIsAnInputError) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "absent" / "file";
  EXPECT_THAT(faultsOf([&] { writeFileAtomically(path, "x"); }),
              HasSubstr(path.string() + ": cannot be written: No such file or directory"));
}

TEST(AtomicFile, FolderInPlaceOfTheFileIsRefusedAndNothingIsLeft) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");
  EXPECT_THAT(faultsOf([&] { writeFileAtomically(folder / "taken", "x"); }),
              HasSubstr("cannot be replaced: Is a directory"));
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, FailedWriteKeepsTheOldFileAndLeavesNoPart) {
  const TemporaryFolder folder;
  writeFileAtomically(folder / "file", "old");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {  // a limit on the size of files stands in for a full disk
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      writeFileAtomically(folder / "file", std::string(5000, 'x'));
    } catch (const std::runtime_error& error) {
      const bool named = std::string(error.what()).find("file: writing failed: File too large") !=
                         std::string::npos;
      ::_exit(named ? 7 : 8);
    }
    ::_exit(9);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(readFile(folder / "file"), "old");
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, ReadingNamesWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(faultsOf([&] { readFile(folder / "absent"); }), HasSubstr("file not found"));
  EXPECT_THAT(faultsOf([&] { readFile(folder.path()); }),
              HasSubstr("expected a file, found a folder"));
  EXPECT_THAT(faultsOf([&] { readFile("/dev/null"); }), HasSubstr("expected a regular file"));
}

TEST(AtomicFile, CreateFolderMakesParentsAndRefusesFiles) {
  const TemporaryFolder folder;
  createFolder(folder / "a/b/c");
  createFolder(folder / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b/c"));
  folder.write("file", "");
  EXPECT_THAT(faultsOf([&] { createFolder(folder / "file"); }),
              HasSubstr("file: the folder cannot be made: Not a directory"));
  EXPECT_THAT(faultsOf([&] { createFolder(folder / "file/below"); }),
              HasSubstr("the folder cannot be made"));
}

}  // namespace
}  // namespace conceptplan
