#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace conceptplan {

/// The first executable file of that name in the folders of the environment variable PATH that are
/// absolute; nothing if there is none.
std::optional<std::filesystem::path> findOnPath(const std::string& program);

}  // namespace conceptplan
