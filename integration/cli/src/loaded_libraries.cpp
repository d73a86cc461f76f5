#include "loaded_libraries.hpp"

#include <link.h>

#include <string>

namespace conceptplan::cli {
namespace {

struct Search {
  std::string_view name_begin;
  std::optional<std::filesystem::path> found;
};

int compare(dl_phdr_info* info, std::size_t, void* data) {
  auto& search = *static_cast<Search*>(data);
  const std::filesystem::path path = info->dlpi_name;
  if (!path.filename().string().starts_with(search.name_begin)) return 0;
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  search.found = error ? path : real;
  return 1;
}

}  // namespace

std::optional<std::filesystem::path> loadedLibrary(std::string_view name_begin) {
  Search search{name_begin, std::nullopt};
  dl_iterate_phdr(compare, &search);
  return search.found;
}

}  // namespace conceptplan::cli
