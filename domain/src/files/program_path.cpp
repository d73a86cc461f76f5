#include "conceptplan/domain/files/program_path.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace conceptplan {

std::optional<std::filesystem::path> findOnPath(const std::string& program) {
  const char* const variable = std::getenv("PATH");
  std::string folders = variable == nullptr ? "" : variable;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const std::filesystem::path file = std::filesystem::path(folders.substr(0, end)) / program;
    std::error_code ignored;
    if (file.is_absolute() && std::filesystem::is_regular_file(file, ignored) &&
        ::access(file.c_str(), X_OK) == 0) {
      return file;
    }
    folders.erase(0, end + 1);
  }
  return std::nullopt;
}

}  // namespace conceptplan
