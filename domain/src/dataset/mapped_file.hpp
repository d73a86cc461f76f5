#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace conceptplan {

/// A file mapped into memory, to read. The file must not be changed while it is mapped; writers of
/// datasets replace files whole.
class MappedFile {
 public:
  /// @throws InputError if the file is missing, empty or unreadable.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  MappedFile& operator=(MappedFile&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string_view bytes() const { return {static_cast<const char*>(data_), size_}; }

 private:
  std::filesystem::path path_;
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace conceptplan
