#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace conceptplan {

/// Replaces a file as a whole: the bytes go to a temporary name in the same folder, are flushed to
/// the disk and renamed, so that a reader finds the old file or the new one, never a part.
/// Whatever goes wrong, no temporary file is left. Thread-safe for different paths.
/// @throws InputError if the folder is missing or nothing can be created in it.
/// @throws std::runtime_error with path and reason if writing fails later, e.g. on a full disk.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// All bytes of a regular file.
/// @throws InputError if it is missing, not a regular file or unreadable.
std::string readFile(const std::filesystem::path& path);

/// The folder, with its parents, made if need be.
/// @throws InputError if that is impossible, e.g. because a file of that name exists.
void createFolder(const std::filesystem::path& path);

}  // namespace conceptplan
