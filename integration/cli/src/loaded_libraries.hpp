#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace conceptplan::cli {

/// The file of a shared library of this process whose name begins so, with links followed: its
/// name carries the version that really runs. Nothing if none is loaded.
std::optional<std::filesystem::path> loadedLibrary(std::string_view name_begin);

}  // namespace conceptplan::cli
