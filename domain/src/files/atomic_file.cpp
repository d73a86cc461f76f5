#include "conceptplan/domain/files/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

std::string errorText(int error) { return std::generic_category().message(error); }

[[noreturn]] void failInput(const std::filesystem::path& path, const std::string& message) {
  throw InputError({Fault{path.string(), {}, {}, "", message}});
}

/// Closes its file and, unless it was renamed away, removes it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) {
    static std::atomic<unsigned> counter{0};
    path_ = target.parent_path() /
            ("." + target.filename().string() + "." + std::to_string(::getpid()) + "." +
             std::to_string(counter++) + ".tmp");
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) failInput(target, "cannot be written: " + errorText(errno));
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(path_.c_str());
  }

  /// 0, or the error's number.
  int write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) return errno;
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    return closed == 0 ? 0 : errno;
  }

  int renameTo(const std::filesystem::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
    renamed_ = true;
    return 0;
  }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  if (!path.has_filename()) failInput(path, "cannot be written: not the name of a file");
  TemporaryFile file(path);
  if (const int error = file.write(bytes)) {
    throw std::runtime_error(path.string() + ": writing failed: " + errorText(error));
  }
  if (const int error = file.renameTo(path)) {
    failInput(path, "cannot be replaced: " + errorText(error));
  }
}

std::string readFile(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    failInput(path, errno == ENOENT ? "file not found" : "cannot be read: " + errorText(errno));
  }
  struct Closer {
    int descriptor;
    ~Closer() { ::close(descriptor); }
  } closer{descriptor};
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) failInput(path, "cannot be read: " + errorText(errno));
  if (!S_ISREG(status.st_mode)) {
    failInput(path, S_ISDIR(status.st_mode) ? "expected a file, found a folder"
                                            : "expected a regular file");
  }
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const ssize_t count = ::read(descriptor, bytes.data() + size, bytes.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failInput(path, "cannot be read: " + errorText(errno));
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  bytes.resize(size);
  return bytes;
}

void createFolder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) failInput(path, "the folder cannot be made: " + error.message());
}

}  // namespace conceptplan
